#ifndef TICKER_REPORT_MARKDOWN_H
#define TICKER_REPORT_MARKDOWN_H

#include <string>
#include <string_view>

namespace ticker::report {

/// A ticker's comment, CommonMark, as HTML. Markup in it is text (`vector<int>` stays what it is),
/// headings become paragraphs, pictures their words, a newline stays one. Needs no further
/// escaping.
[[nodiscard]] std::string markdownHtml(std::string_view text);

}  // namespace ticker::report

#endif
