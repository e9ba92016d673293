#ifndef TICKER_CORPUS_MADEFILE_H
#define TICKER_CORPUS_MADEFILE_H

#include <string>
#include <variant>
#include <vector>

namespace ticker::corpus {

/// A member of an archive that an entry brings.
struct Member {
    enum class Kind { file, symbolicLink, hardLink, device, pipe };
    std::string name;  ///< as it is written into the archive, whatever it may be
    Kind kind = Kind::file;
    std::string text;           ///< a file's contents, or where a link leads
    unsigned long repeats = 1;  ///< how often a file's contents are repeated
    unsigned long copies = 1;   ///< more than one: so many members, named name0, name1, ...
};

/// Files that are too large, too odd or not permitted in a repository, made when they are needed.
struct MadeText {
    std::string before;
    std::string repeated;
    unsigned long times = 0;
    std::string after;
};
struct MadeBytes {
    std::string bytes;
};
struct MadeLink {
    std::string target;
};
struct MadePipe {};
struct MadeFolder {};
struct MadeArchive {
    std::vector<Member> members;  ///< zip or tar, by the name's ending
};
struct MadeFile {
    std::string name;
    std::variant<MadeText, MadeBytes, MadeLink, MadePipe, MadeFolder, MadeArchive> contents;
};

}  // namespace ticker::corpus

#endif
