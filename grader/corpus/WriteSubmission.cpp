#include <grader/corpus/Entry.h>

#include <raytracer/base/Error.h>

#include <archive.h>
#include <archive_entry.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <memory>

namespace ticker::corpus {
namespace fs = std::filesystem;
namespace {

std::string aimed(std::string text, const std::string& secret) {
    constexpr std::string_view kMark = "@SECRET@";
    for (std::size_t at = text.find(kMark); at != std::string::npos; at = text.find(kMark, at))
        text.replace(at, kMark.size(), secret);
    return text;
}

void writeText(const fs::path& file, const std::string& text, const std::string& repeated = {},
               unsigned long times = 0, const std::string& after = {}) {
    std::ofstream stream{file, std::ios::binary};
    stream << text;
    for (unsigned long i = 0; i < times; ++i)
        stream << repeated;
    stream << after;
    if (!stream.flush()) throw raytracer::Error("cannot write " + file.string());
}

using Archive = std::unique_ptr<archive, decltype(&archive_write_free)>;
using Description = std::unique_ptr<archive_entry, decltype(&archive_entry_free)>;

void require(int status, archive* archive) {
    if (status < ARCHIVE_WARN) throw raytracer::Error(archive_error_string(archive));
}

Description describe(const Member& member, const std::string& name, const std::string& text) {
    Description entry{archive_entry_new(), archive_entry_free};
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_size(entry.get(), 0);
    switch (member.kind) {
        case Member::Kind::file:
            archive_entry_set_size(entry.get(),
                                   static_cast<la_int64_t>(text.size() * member.repeats));
            break;
        case Member::Kind::symbolicLink:
            archive_entry_set_filetype(entry.get(), AE_IFLNK);
            archive_entry_set_symlink(entry.get(), text.c_str());
            break;
        case Member::Kind::hardLink:
            archive_entry_set_hardlink(entry.get(), text.c_str());
            break;
        case Member::Kind::device:
            archive_entry_set_filetype(entry.get(), AE_IFCHR);
            archive_entry_set_rdevmajor(entry.get(), 1);
            archive_entry_set_rdevminor(entry.get(), 5);
            break;
        case Member::Kind::pipe:
            archive_entry_set_filetype(entry.get(), AE_IFIFO);
            break;
    }
    return entry;
}

void addMember(archive* archive, const Member& member, const std::string& secret) {
    const std::string text = aimed(member.text, secret);
    for (unsigned long copy = 0; copy < member.copies; ++copy) {
        const std::string name =
            member.copies == 1 ? member.name : member.name + std::to_string(copy);
        const Description entry = describe(member, name, text);
        require(archive_write_header(archive, entry.get()), archive);
        if (member.kind != Member::Kind::file) continue;
        for (unsigned long i = 0; i < member.repeats; ++i)
            if (archive_write_data(archive, text.data(), text.size()) < 0)
                throw raytracer::Error(archive_error_string(archive));
    }
}

void writeArchive(const fs::path& file, const MadeArchive& made, const std::string& secret) {
    const Archive archive{archive_write_new(), archive_write_free};
    const bool isZip = file.extension() == ".zip";
    require(isZip ? archive_write_set_format_zip(archive.get())
                  : archive_write_set_format_pax_restricted(archive.get()),
            archive.get());
    require(archive_write_open_filename(archive.get(), file.c_str()), archive.get());
    for (const Member& member : made.members) {
        // An archive of tens of thousands of empty files takes a minute to compress.
        if (isZip)
            require(member.text.empty() ? archive_write_zip_set_compression_store(archive.get())
                                        : archive_write_zip_set_compression_deflate(archive.get()),
                    archive.get());
        addMember(archive.get(), member, secret);
    }
    require(archive_write_close(archive.get()), archive.get());
}

struct Maker {
    fs::path file;
    std::string secret;

    void operator()(const MadeText& made) const {
        writeText(file, aimed(made.before, secret), made.repeated, made.times, made.after);
    }
    void operator()(const MadeBytes& made) const { writeText(file, made.bytes); }
    void operator()(const MadeLink& made) const {
        fs::create_symlink(aimed(made.target, secret), file);
    }
    void operator()(const MadePipe&) const {
        if (mkfifo(file.c_str(), 0644) != 0)
            throw raytracer::Error("cannot make the pipe " + file.string());
    }
    void operator()(const MadeFolder&) const { fs::create_directory(file); }
    void operator()(const MadeArchive& made) const { writeArchive(file, made, secret); }
};

}  // namespace

void writeSubmission(const Entry& entry, const fs::path& secret, const fs::path& folder) {
    for (const auto& [name, text] : textsOf(entry))
        writeText(folder / name, aimed(text, secret.string()));
    for (const MadeFile& made : entry.made)
        std::visit(Maker{folder / made.name, secret.string()}, made.contents);
}

}  // namespace ticker::corpus
