#ifndef TICKER_CALIBRATE_DOCUMENT_H
#define TICKER_CALIBRATE_DOCUMENT_H

#include <filesystem>
#include <string>

namespace ticker::calibrate {

/// The text between `<!-- calibrate: NAME -->` and `<!-- end -->`, without the line breaks next to
/// the marks; empty if the document has no such section.
[[nodiscard]] std::string sectionOf(const std::string& document, const std::string& name);

/// The document with that text replaced; a missing section is added at the end.
[[nodiscard]] std::string withSection(const std::string& document, const std::string& name,
                                      const std::string& text);

/// Replaces a file whole, unless it has this text already.
void writeIfChanged(const std::string& text, const std::filesystem::path& file);

}  // namespace ticker::calibrate

#endif
