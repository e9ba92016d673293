#include "Xml.h"

#include "FileBytes.h"

#include <raytracer/base/Error.h>
#include <raytracer/base/Text.h>

#include <tinyxml2.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace raytracer {
namespace {

constexpr std::size_t kLargestXml = 1024UL * 1024UL;
constexpr int kMostElements = 10'000;
constexpr int kDeepestLevel = 8;

std::string_view meaningOf(tinyxml2::XMLError error) {
    switch (error) {
        case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
            return "the file holds no element; expected <scene> ... </scene>";
        case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
            return "an element is not closed, or closed by another name; expected "
                   "<name .../> or <name> ... </name>";
        case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
            return "a broken attribute, or one that is given twice; expected name=\"value\"";
        case tinyxml2::XML_ERROR_PARSING_COMMENT:
            return "a comment is not closed; expected -->";
        case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
            return "elements are nested too deeply";
        default:
            return "broken XML, or an element that is not closed; expected <name "
                   "attribute=\"value\"/>";
    }
}

/// Converts the parser's document into plain elements.
class Converter {
public:
    explicit Converter(std::string file) : file_(std::move(file)) {}

    XmlElement convert(const tinyxml2::XMLElement& source, int level) {
        if (level > kDeepestLevel) fail(source.GetLineNum(), "elements are nested too deeply");
        if (++count_ > kMostElements)
            fail(source.GetLineNum(), "more than " + std::to_string(kMostElements) + " elements");
        XmlElement element{source.Name(), source.GetLineNum(), {}, {}};
        for (const tinyxml2::XMLAttribute* attribute = source.FirstAttribute();
             attribute != nullptr; attribute = attribute->Next())
            element.attributes.push_back(
                {attribute->Name(), attribute->Value(), attribute->GetLineNum()});
        for (const tinyxml2::XMLNode* node = source.FirstChild(); node != nullptr;
             node = node->NextSibling()) {
            if (const tinyxml2::XMLElement* child = node->ToElement(); child != nullptr)
                element.children.push_back(convert(*child, level + 1));
            else
                refuseContent(*node);
        }
        return element;
    }

    /// Rejects everything between elements except comments and the XML declaration.
    void refuseContent(const tinyxml2::XMLNode& node) const {
        if (node.ToComment() != nullptr || node.ToDeclaration() != nullptr) return;
        fail(node.GetLineNum(),
             "found " + inQuotes(node.Value()) + "; expected only elements here");
    }

    [[noreturn]] void fail(int line, const std::string& message) const {
        throw InputError(file_, line, message);
    }

private:
    std::string file_;
    int count_ = 0;
};

int lineOf(std::string_view bytes, std::size_t offset) {
    return 1 + static_cast<int>(std::count(
                   bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

void refuseOtherEncodings(std::string_view bytes, const Converter& converter) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
        converter.fail(1, "the file is UTF-16 text; save it as UTF-8");
    if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos)
        converter.fail(lineOf(bytes, zero), "a zero byte; expected XML text");
}

// Scenes are copied out of the original handout, whose wrapped lines begin with an arrow.
std::string wrapHint(std::string_view bytes) {
    return bytes.find("\xE2\x86\xAA") == std::string_view::npos
               ? ""
               : "; delete the arrows that mark wrapped lines in the handout";
}

}  // namespace

XmlElement readXml(const std::filesystem::path& file) {
    const std::string bytes = readFileBytes(file, kLargestXml);
    Converter converter{file.string()};
    refuseOtherEncodings(bytes, converter);

    tinyxml2::XMLDocument document;
    if (document.Parse(bytes.data(), bytes.size()) != tinyxml2::XML_SUCCESS)
        converter.fail(std::max(1, document.ErrorLineNum()),
                       std::string(meaningOf(document.ErrorID())) + wrapHint(bytes));
    const tinyxml2::XMLElement* root = document.RootElement();
    if (root == nullptr)
        converter.fail(1, std::string(meaningOf(tinyxml2::XML_ERROR_EMPTY_DOCUMENT)));
    for (const tinyxml2::XMLNode* node = document.FirstChild(); node != nullptr;
         node = node->NextSibling()) {
        if (node == root) continue;
        if (node->ToElement() != nullptr)
            converter.fail(node->GetLineNum(), "a second outermost element <" +
                                                   std::string(node->Value()) +
                                                   ">; expected only one");
        converter.refuseContent(*node);
    }
    return converter.convert(*root, 1);
}

}  // namespace raytracer
