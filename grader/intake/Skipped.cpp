#include <grader/base/Utf8.h>
#include <grader/intake/Contents.h>
#include <grader/intake/OutFolder.h>
#include <grader/intake/Skipped.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

namespace ticker::intake {
namespace fs = std::filesystem;
namespace {

bool isBelow(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

// An archive whose name isArchive does not recognise.
bool isOtherArchive(const std::string& file) {
    constexpr std::array<std::string_view, 7> kEndings{".rar", ".7z",  ".gz",  ".bz2",
                                                       ".xz",  ".zst", ".zipx"};
    const std::string name = lowerCase(file);
    return !isArchive(name) && std::ranges::any_of(kEndings, [&](std::string_view ending) {
        return name.size() > ending.size() && name.ends_with(ending);
    });
}

std::string whyNotGraded(const fs::directory_entry& entry) {
    std::error_code error;
    if (!entry.is_directory(error)) return "is no zip or tar";
    if (entry.path().filename().string().starts_with('.')) return "its name begins with a dot";
    if (entry.is_symlink(error)) return "is a link";
    if (holdsResults(entry.path())) return "holds results of ticker";
    const bool isEmpty = fs::is_empty(entry.path(), error);
    if (error) return "cannot be read";
    return isEmpty ? "is empty" : "holds nothing to grade";
}

/// Collects what belongs to no submission. Descends only into folders that contain submissions.
class Search {
public:
    Search(fs::path top, const std::vector<Located>& found, const fs::path& out)
        : top_(std::move(top)), found_(found), out_(out) {}

    void in(const fs::path& folder) {
        std::error_code error;
        fs::directory_iterator entry{folder, error};
        for (; !error && entry != fs::directory_iterator{}; entry.increment(error))
            at(*entry);
    }

    [[nodiscard]] std::vector<Skipped> take() {
        std::ranges::sort(skipped_, {}, &Skipped::name);
        return std::move(skipped_);
    }

private:
    void at(const fs::directory_entry& entry) {
        std::error_code error;
        const bool isFolder = entry.is_directory(error);
        const std::string name = entry.path().filename().string();
        if (isLitter(name) || !(isFolder || isOtherArchive(name)) || isGraded(entry.path()) ||
            fs::equivalent(entry.path(), out_, error))
            return;
        if (isFolder && !entry.is_symlink(error) && holdsGraded(entry.path()))
            in(entry.path());
        else
            skipped_.push_back(
                {asPlainLine(entry.path().lexically_relative(top_).string()), whyNotGraded(entry)});
    }

    [[nodiscard]] bool isGraded(const fs::path& path) const {
        return std::ranges::any_of(
            found_, [&](const Located& located) { return isBelow(path, located.path); });
    }

    [[nodiscard]] bool holdsGraded(const fs::path& folder) const {
        return std::ranges::any_of(
            found_, [&](const Located& located) { return isBelow(located.path, folder); });
    }

    fs::path top_;
    const std::vector<Located>& found_;
    const fs::path& out_;
    std::vector<Skipped> skipped_;
};

}  // namespace

std::vector<Skipped> findSkipped(const fs::path& path, const std::vector<Located>& found,
                                 const fs::path& out) {
    std::error_code error;
    const fs::path top = fs::canonical(path, error);
    if (error) return {};
    Search search{top, found, out};
    search.in(top);
    return search.take();
}

}  // namespace ticker::intake
