#ifndef TICKER_HOSTILE_HOSTILECASE_H
#define TICKER_HOSTILE_HOSTILECASE_H

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace ticker::hostile {

/// A member of an archive that a case brings.
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

/// One hostile or broken submission, and what the grader must say to it. Where several answers are
/// listed, any one is right: which limit strikes first differs between machines.
struct HostileCase {
    std::string name;                 ///< its folder's
    std::string handedInAs;           ///< name of the folder in the class; mostly `name`
    std::string about;                ///< what it tries, in one line
    std::string task;                 ///< whose state is told: "T1", "T2.1" or "T2.2"
    std::vector<std::string> states;  ///< as in result.json
    std::vector<std::string>
        findings;  ///< one of these must be among the result's, where it cannot pass or must pass
    std::vector<std::string> verdicts;  ///< as in result.json
    std::filesystem::path folder;
    std::vector<MadeFile> made;
};

/// The corpus, by name. @param folder  grader/corpus/hostile/cases.
/// @throws raytracer::InputError naming the case and the field that is wrong.
[[nodiscard]] std::vector<HostileCase> listHostileCases(const std::filesystem::path& folder);

/// Writes the submission into `folder`, which must exist and be empty.
/// @param secret  Path of a file that the submission shall go for: stands for `@SECRET@` in its
///                texts. Its contents must turn up in no output.
/// @throws raytracer::Error where it cannot be written.
void writeSubmission(const HostileCase& hostileCase, const std::filesystem::path& secret,
                     const std::filesystem::path& folder);

}  // namespace ticker::hostile

#endif
