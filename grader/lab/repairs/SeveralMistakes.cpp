#include <grader/lab/repairs/SeveralMistakes.h>

#include <grader/base/JsonValue.h>
#include <grader/base/WholeFile.h>

namespace ticker::lab {

SeveralMistakes readSeveralMistakes(const std::filesystem::path& data) {
    const std::filesystem::path file =
        data / "grader" / "lab" / "repairs" / "several-mistakes.json";
    const JsonValue top = JsonValue::parse(readWhole(file), file.string());
    SeveralMistakes several;
    for (const auto& [name, reason] : top.members())
        several.emplace(name, reason.text());
    return several;
}

}  // namespace ticker::lab
