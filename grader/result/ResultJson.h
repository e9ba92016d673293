#ifndef TICKER_RESULT_RESULTJSON_H
#define TICKER_RESULT_RESULTJSON_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>

namespace ticker {

/// The text of result.json: schema version 1, see docs/schema/result.schema.json. Numbers that are
/// not finite become null.
[[nodiscard]] std::string resultJson(const SubmissionResult& result);

/// Reads a result.json back. What the file does not hold (the bytes of pictures, the values of
/// rasters) stays empty.
/// @throws raytracer::InputError naming the file, the member and what was expected; the file may be
///         anything.
[[nodiscard]] SubmissionResult readResultJson(const std::filesystem::path& file);

/// The same from the file's text; `name` is for messages.
[[nodiscard]] SubmissionResult parseResultJson(const std::string& text, const std::string& name);

}  // namespace ticker

#endif
