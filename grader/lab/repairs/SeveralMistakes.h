#ifndef TICKER_LAB_REPAIRS_SEVERALMISTAKES_H
#define TICKER_LAB_REPAIRS_SEVERALMISTAKES_H

#include <filesystem>
#include <map>
#include <string>

namespace ticker::lab {

/// Wrong submissions that no single idea mends, and why: two independent mistakes, or another
/// algorithm. By the name of their row.
using SeveralMistakes = std::map<std::string, std::string>;

/// Reads several-mistakes.json.
/// @param data  The project's folder.
/// @throws raytracer::InputError if the file cannot be read or is no object of texts.
[[nodiscard]] SeveralMistakes readSeveralMistakes(const std::filesystem::path& data);

}  // namespace ticker::lab

#endif
