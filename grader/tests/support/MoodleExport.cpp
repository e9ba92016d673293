#include <grader/tests/support/MoodleExport.h>

#include <archive.h>
#include <archive_entry.h>
#include <locale.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace ticker::tests {
namespace {

// As Moodle's clean_filename(): removes control characters and & < > " ` | ' : \ /.
std::string cleaned(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (static_cast<unsigned char>(c) >= 0x20 &&
            std::string_view{"&<>\"`|':\\/"}.find(c) == std::string_view::npos)
            result += c;
    return result;
}

std::string prefixOf(const MoodleStudent& student, const MoodleLayout& layout) {
    std::string name = layout.blind ? "Participant" : student.fullName;
    if (!student.group.empty()) name = student.group + "-" + name;
    std::ranges::replace(name, '_', ' ');
    if (student.id != 0) name += "_" + std::to_string(student.id);
    return cleaned(name) + "_assignsubmission_";
}

std::string pathOf(const std::string& prefix, const std::string& plugin, const std::string& file,
                   const MoodleLayout& layout) {
    if (layout.folders) return prefix + plugin + (layout.trailingUnderscore ? "_/" : "/") + file;
    return prefix + plugin + "_" + cleaned(file.substr(file.find_last_of('/') + 1));
}

/// Makes this thread's character set UTF-8, so that the zip says that its names are.
class Utf8Names {
public:
    Utf8Names() : before_(uselocale(utf8_)) {}
    ~Utf8Names() {
        uselocale(before_);
        freelocale(utf8_);
    }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    locale_t utf8_ = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
    locale_t before_;
};

void check(bool good, archive* handle, const std::filesystem::path& file) {
    if (good) return;
    const char* why = archive_error_string(handle);
    throw std::runtime_error(file.string() + ": " + (why == nullptr ? "no zip" : why));
}

void writeMember(archive* handle, const NamedBytes& member, const std::filesystem::path& file) {
    const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry{archive_entry_new(),
                                                                              archive_entry_free};
    archive_entry_set_pathname(entry.get(), member.path.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(member.bytes.size()));
    check(archive_write_header(handle, entry.get()) == ARCHIVE_OK, handle, file);
    const la_ssize_t size = archive_write_data(handle, member.bytes.data(), member.bytes.size());
    check(size == static_cast<la_ssize_t>(member.bytes.size()), handle, file);
}

}  // namespace

std::vector<NamedBytes> moodleExport(const std::vector<MoodleStudent>& students,
                                     const MoodleLayout& layout) {
    std::vector<NamedBytes> members;
    for (const MoodleStudent& student : students) {
        const std::string prefix = prefixOf(student, layout);
        for (const NamedBytes& file : student.files)
            members.push_back({pathOf(prefix, "file", file.path, layout), file.bytes});
        if (!student.onlineText.empty())
            members.push_back(
                {pathOf(prefix, "onlinetext", "onlinetext.html", layout), student.onlineText});
    }
    return members;
}

void writeZip(const std::filesystem::path& file, const std::vector<NamedBytes>& members) {
    const Utf8Names utf8;
    const std::unique_ptr<archive, decltype(&archive_write_free)> handle{archive_write_new(),
                                                                         archive_write_free};
    archive_write_set_format_zip(handle.get());
    check(archive_write_open_filename(handle.get(), file.c_str()) == ARCHIVE_OK, handle.get(),
          file);
    for (const NamedBytes& member : members)
        writeMember(handle.get(), member, file);
    check(archive_write_close(handle.get()) == ARCHIVE_OK, handle.get(), file);
}

void writeFolder(const std::filesystem::path& folder, const std::vector<NamedBytes>& members) {
    for (const NamedBytes& member : members) {
        const std::filesystem::path file = folder / member.path;
        std::filesystem::create_directories(file.parent_path());
        if (!(std::ofstream{file, std::ios::binary} << member.bytes))
            throw std::runtime_error("cannot write " + file.string());
    }
}

}  // namespace ticker::tests
