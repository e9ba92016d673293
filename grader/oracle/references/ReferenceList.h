#ifndef TICKER_ORACLE_REFERENCELIST_H
#define TICKER_ORACLE_REFERENCELIST_H

#include <grader/oracle/references/References.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::oracle {

/// Reads `references.json` of a folder of scenes, and every scene that it names:
/// `{"references": [{"scene": "relief", "pinhole": true, "width": 320, "height": 240}]}`.
///
/// @param assets  Where bump maps are looked up.
/// @throws raytracer::InputError naming the file, the entry and what was expected there.
[[nodiscard]] std::vector<ReferenceScene> readReferenceList(const std::filesystem::path& scenes,
                                                            const std::filesystem::path& assets);

/// The scenes of the folder that `listed` leaves out, by name.
[[nodiscard]] std::vector<std::string> scenesWithoutReference(
    const std::filesystem::path& scenes, const std::vector<ReferenceScene>& listed);

}  // namespace ticker::oracle

#endif
