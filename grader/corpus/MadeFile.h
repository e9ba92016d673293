#ifndef TICKER_CORPUS_MADEFILE_H
#define TICKER_CORPUS_MADEFILE_H

#include <string>
#include <variant>
#include <vector>

namespace ticker::corpus {

/// A member of an archive that belongs to an entry.
struct Member {
    enum class Kind { file, symbolicLink, hardLink, device, pipe };
    std::string name;  ///< name in the archive, written unchanged even if it is invalid
    Kind kind = Kind::file;
    std::string text;           ///< contents of a file, or target of a link
    unsigned long repeats = 1;  ///< number of repetitions of the contents
    unsigned long copies = 1;   ///< more than one: this many members, named name0, name1, ...
};

/// A text: `before`, then `times` repetitions of `repeated`, then `after`.
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
    std::vector<Member> members;  ///< zip or tar, by the ending of the name
};
/// A file that is too large, too odd or not permitted in a repository, and is made on demand.
struct MadeFile {
    std::string name;
    std::variant<MadeText, MadeBytes, MadeLink, MadePipe, MadeFolder, MadeArchive> contents;
};

}  // namespace ticker::corpus

#endif
