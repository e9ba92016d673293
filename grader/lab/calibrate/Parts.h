#ifndef TICKER_CALIBRATE_PARTS_H
#define TICKER_CALIBRATE_PARTS_H

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::calibrate {

/// The code that a result belongs to: a short digest of each part that it depends on, by name.
using Stamp = std::map<std::string, std::string>;

/// Key in a stamp for what a unit alone depends on, such as the text of its entry.
inline constexpr std::string_view kOwnPart = "entry";

/// The parts of the source tree that results depend on, as parts.json has them.
class Parts {
public:
    /// @param root  The checkout.
    /// @throws raytracer::InputError if grader/lab/calibrate/parts.json cannot be read, or names a
    ///         part or a path that is not there.
    explicit Parts(const std::filesystem::path& root);

    /// The digests of the parts that a measurement depends on.
    /// @param measured  A task's id, or the name of another measurement. A task without a row in
    ///                  parts.json has the row "any other task".
    /// @throws raytracer::InputError if parts.json has no such row.
    [[nodiscard]] Stamp stampOf(std::string_view measured) const;

    /// Files of the parts of a measurement, as paths in the checkout.
    [[nodiscard]] std::vector<std::filesystem::path> filesOf(std::string_view measured) const;
    /// Words for a part in messages: its first path ("grader/tasks/shadows"), or "the part NAME" if
    /// it has more than two paths.
    [[nodiscard]] std::string placeOf(const std::string& part) const;

private:
    struct Part {
        std::vector<std::string> paths;
        std::vector<std::filesystem::path> files;  // sorted, in the checkout
        std::string digest;
    };
    [[nodiscard]] const std::vector<std::string>& partsOf(std::string_view measured) const;

    std::filesystem::path table_;
    std::map<std::string, Part> parts_;
    std::map<std::string, std::vector<std::string>, std::less<>> measured_;
};

/// The digest of a text, comments and white space included: 8 hexadecimal digits.
[[nodiscard]] std::string shortDigest(std::string_view text);

}  // namespace ticker::calibrate

#endif
