#include <grader/package/Bundle.h>
#include <grader/package/Platforms.h>

namespace ticker::package {
namespace {

namespace fs = std::filesystem;

void addScript(zip::ZipWriter& zip, const Parts& parts, const std::string& inside,
               const std::string& source) {
    zip.add(inside, integration(parts, source), true);
}

}  // namespace

void writeGradescope(const Parts& parts, const fs::path& file) {
    zip::ZipWriter zip{file};
    addScript(zip, parts, "setup.sh", "gradescope/setup.sh");
    addScript(zip, parts, "run_autograder", "gradescope/run_autograder");
    addBundle(zip, parts);
    zip.finish();
}

void writePrairieLearn(const Parts& parts, const fs::path& file) {
    zip::ZipWriter zip{file};
    zip.add("Dockerfile", integration(parts, "prairielearn/Dockerfile"));
    addScript(zip, parts, "entrypoint.sh", "prairielearn/entrypoint.sh");
    for (const char* page : {"question/info.json", "question/question.html"})
        zip.add(page, integration(parts, std::string{"prairielearn/"} + page));
    addBundle(zip, parts);
    zip.finish();
}

}  // namespace ticker::package
