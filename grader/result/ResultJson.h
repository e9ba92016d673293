#ifndef TICKER_RESULT_RESULTJSON_H
#define TICKER_RESULT_RESULTJSON_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>

namespace ticker {

/// The text of result.json: schema version 1, see docs/schema/result.schema.json. NaN and infinity
/// become null.
[[nodiscard]] std::string resultJson(const SubmissionResult& result);

/// Reads a result.json back. Data that the file does not contain (bytes of pictures, values of
/// rasters) stays empty.
/// @throws raytracer::InputError with the file, the member and what was expected; the file may have
///         any contents.
[[nodiscard]] SubmissionResult readResultJson(const std::filesystem::path& file);

/// readResultJson for a text; `name` is used in messages.
[[nodiscard]] SubmissionResult parseResultJson(const std::string& text, const std::string& name);

}  // namespace ticker

#endif
