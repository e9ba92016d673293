// result.json as `ticker report` reads it, from any source.
#include "../report/ExampleResults.h"
#include "../support/TemporaryFolder.h"
#include "Fuzz.h"

#include <grader/result/ResultJson.h>

#include <raytracer/base/Error.h>

namespace ticker::fuzz {

bool give(std::string_view input) {
    static const tests::TemporaryFolder folder;
    folder.write("result.json", input);
    try {
        const SubmissionResult result = readResultJson(folder.path() / "result.json");
        require(!resultJson(result).empty(), "what was read can be written");
        return true;
    } catch (const raytracer::InputError&) {
        return false;
    }
}

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    for (const SubmissionResult& result :
         {report::passedExample(), report::failedBumpExample(), report::failedLensExample(),
          report::blockedExample(), report::hostileExample()})
        texts.push_back(resultJson(result));
    return texts;
}

}  // namespace ticker::fuzz
