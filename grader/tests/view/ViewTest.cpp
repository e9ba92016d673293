#include <student_template/framework/app/view/View.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace raytracer::view {
namespace {

std::string refusalOf(const std::vector<std::string>& arguments) {
    try {
        static_cast<void>(run(parseOptions(arguments)));
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(View, RefusesOptionsThatItWouldDrop) {
    const std::vector<std::vector<std::string>> others{
        {"-o", "a.png"},        {"--region", "0,0,4,4"}, {"--trace", "1,1"}, {"--normals"},
        {"--compare", "b.png"}, {"--linear", "a.pfm"},   {"--preview"}};
    for (std::vector<std::string> arguments : others) {
        const std::string name = arguments[0];
        arguments.insert(arguments.begin(), {"--view", "no-such-scene.xml"});
        EXPECT_EQ(refusalOf(arguments), name + ": --view has no use for it; leave one of them out");
    }
    // This one gets as far as reading the scene.
    const std::string missing = refusalOf({"--view", "no-such-scene.xml", "--threads", "2", "-q"});
    EXPECT_NE(missing.find("no-such-scene.xml"), std::string::npos) << missing;
}

}  // namespace
}  // namespace raytracer::view
