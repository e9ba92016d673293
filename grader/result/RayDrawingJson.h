#ifndef TICKER_RESULT_RAYDRAWINGJSON_H
#define TICKER_RESULT_RAYDRAWINGJSON_H

#include <grader/base/JsonValue.h>
#include <grader/result/RayDrawing.h>

#include <string>

namespace ticker {

/// The drawing as JSON, in the format of the page's script. Safe inside an HTML script element: it
/// contains no "<".
[[nodiscard]] std::string rayDrawingJson(const RayDrawing& drawing);

/// Reads a drawing back. @throws raytracer::InputError naming the member and what was expected.
[[nodiscard]] RayDrawing readRayDrawing(const JsonValue& place);

}  // namespace ticker

#endif
