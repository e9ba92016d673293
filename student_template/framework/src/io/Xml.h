#ifndef RAYTRACER_SRC_IO_XML_H
#define RAYTRACER_SRC_IO_XML_H

#include <filesystem>
#include <string>
#include <vector>

namespace raytracer {

struct XmlAttribute {
    std::string name;
    std::string value;
    int line = 0;  ///< counted from 1
};

/// An element with its attributes and children; text is not allowed in our files.
struct XmlElement {
    std::string name;
    int line = 0;  ///< counted from 1
    std::vector<XmlAttribute> attributes;
    std::vector<XmlElement> children;
};

/// The root element of an XML file.
/// @throws InputError with file and line: missing or over 1 MiB, not UTF-8, broken XML, more than
///         one root, text between elements, an attribute given twice, more than 10 000 elements or
///         more than 8 levels of them.
[[nodiscard]] XmlElement readXml(const std::filesystem::path& file);

}  // namespace raytracer

#endif
