
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>
#include <raytracer/io/SceneReader.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>

namespace raytracer {
namespace {

using ticker::tests::TemporaryFolder;

struct BadScene {
    std::string name;
    std::string xml;
    int line;
    std::string expected;  // must occur in the message

    friend std::ostream& operator<<(std::ostream& out, const BadScene& scene) {
        return out << scene.name;
    }
};

std::string around(const std::string& element) {
    return "<scene>\n<sphere colour='#000000'/>\n" + element + "\n</scene>\n";
}

BadScene badElement(const std::string& name, const std::string& element,
                    const std::string& expected) {
    return {name, around(element), 3, expected};
}

std::string repeated(std::string_view text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i)
        all += text;
    return all;
}

class BadSceneFile : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadSceneFile, IsRefusedWithFileLineAndWhatWasExpected) {
    const TemporaryFolder folder;
    const auto file = folder.write("scene.xml", GetParam().xml);
    folder.write("text.png", "not a picture");
    try {
        (void)readScene(file, {});
        FAIL() << "it was accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        const std::string place = file.string() + ":" + std::to_string(GetParam().line) + ": ";
        EXPECT_TRUE(message.starts_with(place)) << message;
        EXPECT_NE(message.find(GetParam().expected), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_EQ(error.exitCode(), ExitCode::badInput);
    }
}

const auto kBrokenXml = ::testing::Values(
    BadScene{"Empty", "", 1, "expected <scene>"}, BadScene{"Blank", "  \n \n", 1, "<scene>"},
    BadScene{"OnlyAComment", "<!-- nothing -->", 1, "expected <scene>"},
    BadScene{"NoXml", "just some text", 1, "expected"},
    BadScene{"Json", "{\"scene\": []}", 1, "expected"},
    BadScene{"Utf16", std::string("\xFF\xFE<\0s\0c\0", 8), 1, "UTF-8"},
    BadScene{"ZeroByte", std::string("<scene>\n\0</scene>", 17), 2, "zero byte"},
    BadScene{"NeverClosed", "<scene>\n<sphere colour='#000000'/>\n", 1, "not closed"},
    BadScene{"WrongClose", "<scene>\n<sphere colour='#000000'>\n</plane></scene>", 2, "not closed"},
    BadScene{"UnclosedComment", "<scene>\n<!-- oh\n</scene>", 2, "-->"},
    BadScene{"UnquotedValue", around("<sphere radius=1 colour='#000000'/>"), 3, "name=\"value\""},
    BadScene{"UnclosedQuote", around("<sphere radius='1 colour=/>"), 3, "attribute"},
    BadScene{"WrapArrow", around("<sphere radius='1'\n\xE2\x86\xAA colour='#000000'/>"), 4,
             "delete the arrows"},
    BadScene{"TwoRoots", around("") + "<scene/>", 5, "only one"},
    BadScene{"TextInside", around("hello"), 3, "hello\\x0A\"; expected only"},
    BadScene{"Doctype", "<!DOCTYPE scene [<!ENTITY a 'b'>]>\n" + around(""), 1, "only elements"},
    BadScene{"AttributeTwice", around("<sphere colour='#000000' colour='#000000'/>"), 3, "twice"},
    BadScene{"WrongRoot", "<world><sphere colour='#000000'/></world>", 1, "expected <scene>"},
    BadScene{"AttributeOnScene", "<scene\nname='x'><sphere colour='#000000'/></scene>", 2, "none"},
    BadScene{"NestedTooDeeply", repeated("<scene>", 60) + repeated("</scene>", 60), 1, "deeply"},
    BadScene{"NestedFarTooDeeply", repeated("<scene>", 100'000), 1, "deeply"},
    BadScene{"TooManyElements",
             "<scene>" + repeated("<sphere colour='#000000'/>\n", 10'001) + "</scene>", 10'000,
             "10000"},
    BadScene{"NoObject", "<scene>\n<point-light colour='#FFFFFF'/></scene>", 1, "no object"});

const auto kBadElements = ::testing::Values(
    badElement("UnknownElement", "<cube colour='#000000'/>", "known are: ambient-light"),
    badElement("MisspeltElement", "<shpere colour='#000000'/>", "did you mean \"sphere\""),
    badElement("WrongCaseElement", "<Plane colour='#000000' ny='1'/>", "did you mean \"plane\""),
    badElement("ChildOfSphere", "<sphere colour='#000000'><sphere colour='#000000'/></sphere>",
               "holds no elements"),
    badElement("UnknownAttribute", "<sphere colour='#000000' weight='1'/>", "known are: x, y"),
    badElement("MisspeltAttribute", "<sphere color='#000000'/>", "did you mean \"colour\""),
    badElement("WrongCaseAttribute", "<sphere colour='#000000' kd='1'/>", "did you mean \"kD\""),
    badElement("MapOnASmoothSphere", "<sphere colour='#000000' bump-map='map.png'/>",
               "unknown attribute \"bump-map\""),
    badElement("RadiusOnAPlane", "<plane colour='#000000' ny='1' radius='1'/>",
               "unknown attribute \"radius\""),
    badElement("EscapesInANameAreShownAsText", "<sphere \x1B[31m='1' colour='#000000'/>",
               "expected"),
    badElement("NoColour", "<sphere/>", "no \"colour\""),
    badElement("NoLightColour", "<point-light x='1'/>", "no \"colour\""),
    badElement("NoMap", "<bumpy-sphere colour='#000000'/>", "no \"bump-map\""),
    badElement("SecondAmbientLight",
               "<ambient-light colour='#000000'/><ambient-light colour='#000000'/>", "in line 3"));

const auto kBadValues = ::testing::Values(
    badElement("NamedColour", "<sphere colour='red'/>", "#RRGGBB"),
    badElement("ShortColour", "<sphere colour='#FFF'/>", "#RRGGBB"),
    badElement("LongColour", "<sphere colour='#FFFFFFFF'/>", "#RRGGBB"),
    badElement("ColourWithoutHash", "<sphere colour='FFFFFFF'/>", "#RRGGBB"),
    badElement("NoHexadecimalColour", "<sphere colour='#GGGGGG'/>", "#RRGGBB"),
    badElement("SignedColour", "<sphere colour='#-12345'/>", "#RRGGBB"),
    badElement("NotANumber", "<sphere colour='#000000' x='one'/>", "x=\"one\""),
    badElement("Nan", "<sphere colour='#000000' x='nan'/>", "a number"),
    badElement("Infinite", "<sphere colour='#000000' x='inf'/>", "a number"),
    badElement("TooLarge", "<sphere colour='#000000' x='1e10'/>", "-1e9 to 1e9"),
    badElement("BeyondDouble", "<sphere colour='#000000' x='1e999'/>", "-1e9 to 1e9"),
    badElement("Unit", "<sphere colour='#000000' x='1m'/>", "a number"),
    badElement("DecimalComma", "<sphere colour='#000000' x='1,5'/>", "a number"),
    badElement("EmptyNumber", "<sphere colour='#000000' x=''/>", "a number"),
    badElement("Hexadecimal", "<sphere colour='#000000' x='0x1p3'/>", "a number"),
    badElement("ZeroRadius", "<sphere colour='#000000' radius='0'/>", "above 0"),
    badElement("NegativeRadius", "<sphere colour='#000000' radius='-1'/>", "above 0"),
    badElement("NegativeKD", "<sphere colour='#000000' kD='-0.1'/>", "from 0"),
    badElement("NegativeKS", "<sphere colour='#000000' kS='-0.1'/>", "from 0"),
    badElement("NegativeAlpha", "<sphere colour='#000000' alphaS='-1'/>", "from 0"),
    badElement("Reflectivity", "<sphere colour='#000000' reflectivity='1.01'/>", "from 0 to 1"),
    badElement("NegativeIntensity", "<point-light colour='#000000' intensity='-1'/>", "from 0"),
    badElement("NegativeAmbient", "<ambient-light colour='#000000' intensity='-1'/>", "from 0"),
    badElement("NoNormal", "<plane colour='#000000'/>", "normal"),
    badElement("TinyNormal", "<plane colour='#000000' ny='1e-300'/>", "normal"));

const auto kBadMaps = ::testing::Values(
    badElement("EmptyMapName", "<bumpy-sphere colour='#000000' bump-map=''/>", "PNG file"),
    badElement("MissingMap", "<bumpy-sphere colour='#000000' bump-map='no.png'/>", "PNG file in"),
    badElement("MapAbove", "<bumpy-sphere colour='#000000' bump-map='../map.png'/>", "without"),
    badElement("MapAboveInside", "<bumpy-sphere colour='#000000' bump-map='a/../../b'/>",
               "without"),
    badElement("AbsoluteMap", "<bumpy-sphere colour='#000000' bump-map='/etc/passwd'/>",
               "not begin with"),
    badElement("FolderAsMap", "<bumpy-sphere colour='#000000' bump-map='.'/>", "PNG file in"),
    badElement("VeryLongMapName",
               "<bumpy-sphere colour='#000000' bump-map='" + repeated("long", 5000) + "'/>",
               "PNG file in"));

std::string nameOf(const ::testing::TestParamInfo<BadScene>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Xml, BadSceneFile, kBrokenXml, nameOf);
INSTANTIATE_TEST_SUITE_P(Elements, BadSceneFile, kBadElements, nameOf);
INSTANTIATE_TEST_SUITE_P(Values, BadSceneFile, kBadValues, nameOf);
INSTANTIATE_TEST_SUITE_P(Maps, BadSceneFile, kBadMaps, nameOf);

void expectRefused(const std::filesystem::path& file, std::string_view expected) {
    try {
        (void)readScene(file, {});
        FAIL() << "it was accepted";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(message.starts_with(error.file() + ": ")) << message;
        EXPECT_NE(message.find(expected), std::string::npos) << message;
    }
}

TEST(ReadScene, RefusesWhatIsNoReadableFile) {
    const TemporaryFolder folder;
    expectRefused(folder.path() / "no-such.xml", "no such file");
    expectRefused(folder.path(), "a folder");
    expectRefused("/dev/zero", "no regular file");
    expectRefused(folder.write("large.xml", std::string(1024 * 1024 + 1, ' ')), "1 MiB");
}

TEST(ReadScene, NamesTheMapThatIsNoPicture) {
    const TemporaryFolder folder;
    folder.write("text.png", "not a picture");
    const auto file =
        folder.write("scene.xml", around("<bumpy-sphere colour='#000000' bump-map='text.png'/>"));
    expectRefused(file, "text.png: this is no picture");
}

}  // namespace
}  // namespace raytracer
