#include <grader/report/Escape.h>
#include <grader/report/Graphics.h>
#include <grader/report/PageParts.h>
#include <grader/report/PageSources.h>

#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <utility>

namespace ticker::report {
namespace {

// With base64, which adds a third, and the page's own text this stays below 3 MB.
constexpr std::size_t kMostPictureBytes = 2'000'000;

}  // namespace

std::string badge(std::string_view kind, std::string_view words) {
    return fmt::format(R"(<span class="badge {}">{}</span>)", kind, escapeHtml(words));
}

std::string address(std::string_view path) {
    std::string encoded;
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || std::string_view{"-_.~/"}.find(c) != std::string_view::npos)
            encoded += c;
        else
            encoded += fmt::format("%{:02X}", byte);
    }
    return encoded;
}

std::string page(std::string_view title, std::string_view css, std::string_view js,
                 std::string_view body) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
        "img-src data: 'self' file:; style-src 'unsafe-inline'; script-src '{}'; "
        "base-uri 'none'; form-action 'none'\">"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
        "<meta name=\"color-scheme\" content=\"light dark\">"
        "<title>{}</title><style>{}{}</style></head><body>"
        "<a class=\"skip\" href=\"#main\">Skip to the content</a>{}"
        "<script>{}</script></body></html>\n",
        scriptHash(js), escapeHtml(title), commonCss(), css, body, js);
}

Album::Album(const SubmissionResult& result, std::string folder) : folder_(std::move(folder)) {
    std::vector<const ResultPicture*> bySize;
    for (const ResultPicture& picture : result.pictures)
        bySize.push_back(&picture);
    std::stable_sort(bySize.begin(), bySize.end(),
                     [](const ResultPicture* a, const ResultPicture* b) {
                         return a->png.size() < b->png.size();
                     });
    std::size_t room = kMostPictureBytes;
    for (const ResultPicture* picture : bySize) {
        const bool carried = !picture->png.empty() && picture->png.size() <= room;
        if (carried) room -= picture->png.size();
        pictures_[picture->file] =
            carried ? pngAddress(picture->png) : address(folder_ + picture->file);
    }
}

std::string Album::addressOf(const std::string& file) const {
    if (!file.starts_with("images/")) return {};  // no other folder and no other host
    const auto found = pictures_.find(file);
    return found != pictures_.end() ? found->second : address(folder_ + file);
}

}  // namespace ticker::report
