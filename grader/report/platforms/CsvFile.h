#ifndef TICKER_REPORT_CSVFILE_H
#define TICKER_REPORT_CSVFILE_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::report {

/// A CSV file by another program. Unchanged fields are written back byte for byte: quoting, line
/// ends, byte order mark. Parsed as PHP does, which Moodle uses: inside quotes, a quote after a
/// backslash does not end the field.
class CsvFile {
public:
    /// @param name  Name in messages.
    /// @throws raytracer::InputError with a line number, if rows differ in length or a quote is not
    ///         closed.
    CsvFile(std::string_view text, const std::string& name);

    [[nodiscard]] std::size_t rows() const { return records_.size(); }
    [[nodiscard]] std::size_t columns() const { return records_.front().fields.size(); }

    /// The field's value, without quotes. Row 0 is the header.
    [[nodiscard]] std::string value(std::size_t row, std::size_t column) const;

    /// Replaces a field by a quoted one.
    void set(std::size_t row, std::size_t column, std::string_view value);

    [[nodiscard]] std::string text() const;

private:
    struct Record {
        std::vector<std::string> fields;  ///< as written in the file
        std::string end;                  ///< "\r\n", "\n" or nothing
        int line = 0;
    };

    std::string mark_;
    std::vector<Record> records_;
};

}  // namespace ticker::report

#endif
