#include <grader/report/platforms/PlatformFormats.h>

#include "ExampleResults.h"

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <map>
#include <set>
#include <string>

namespace ticker::report {
namespace {

/// One test case as read by Artemis and Jenkins.
struct ReadCase {
    std::string kind = "passed";
    std::string message;
    std::string body;
};

struct ReadSuite {
    std::map<std::string, int> counts;
    std::map<std::string, ReadCase> cases;
};

ReadSuite readBack(const std::string& xml) {
    tinyxml2::XMLDocument document;
    EXPECT_EQ(document.Parse(xml.c_str(), xml.size()), tinyxml2::XML_SUCCESS) << xml;
    ReadSuite read;
    const auto* suite = document.FirstChildElement("testsuites")->FirstChildElement("testsuite");
    EXPECT_EQ(suite->NextSiblingElement(), nullptr) << "a second suite would prefix all names";
    for (const char* name : {"tests", "failures", "errors", "skipped"})
        read.counts[name] = suite->IntAttribute(name, -1);
    for (const auto* test = suite->FirstChildElement("testcase"); test != nullptr;
         test = test->NextSiblingElement("testcase")) {
        EXPECT_NE(test->Attribute("classname"), nullptr);
        ReadCase& known = read.cases[test->Attribute("name")];
        const auto* child = test->FirstChildElement();
        if (child == nullptr || std::string{child->Name()} == "system-out") continue;
        known.kind = child->Name();
        known.message = child->Attribute("message");
        known.body = child->GetText() == nullptr ? "" : child->GetText();
    }
    return read;
}

/// An annotation by mikepenz/action-junit-report (src/testParser.ts, 0289ec7): at a file of the
/// repository whose path ends with the last part of classname and any suffix.
struct Annotation {
    std::string file;
    std::string message;
};

std::map<std::string, Annotation> annotationsOf(const SubmissionResult& result) {
    tinyxml2::XMLDocument document;
    document.Parse(junitXml(StudentView{result, {}}).value().c_str());
    std::map<std::string, Annotation> read;
    const auto* suite = document.FirstChildElement("testsuites")->FirstChildElement("testsuite");
    for (const auto* test = suite->FirstChildElement("testcase"); test != nullptr;
         test = test->NextSiblingElement("testcase")) {
        const auto* failure = test->FirstChildElement("failure");
        if (failure == nullptr) continue;
        const std::string name = test->Attribute("classname");
        read[test->Attribute("name")] = {name.substr(name.rfind('.') + 1),
                                         failure->Attribute("message")};
    }
    return read;
}

/// The groups of dorny/test-reporter (src/parsers/java-junit, 035c1f9): one for each classname,
/// without a name where it is the suite's. It trims the names of suite and cases and reads their
/// times: all of them must be there.
std::map<std::string, std::set<std::string>> groupsOf(const SubmissionResult& result) {
    tinyxml2::XMLDocument document;
    document.Parse(junitXml(StudentView{result, {}}).value().c_str());
    std::map<std::string, std::set<std::string>> groups;
    const auto* suite = document.FirstChildElement("testsuites")->FirstChildElement("testsuite");
    EXPECT_GE(suite->DoubleAttribute("time", -1), 0);
    for (const auto* test = suite->FirstChildElement("testcase"); test != nullptr;
         test = test->NextSiblingElement("testcase")) {
        EXPECT_GE(test->DoubleAttribute("time", -1), 0);
        const std::string name = test->Attribute("classname");
        groups[name == suite->Attribute("name") ? "" : name].insert(test->Attribute("name"));
    }
    return groups;
}

ReadSuite readBack(const SubmissionResult& result) {
    return readBack(junitXml(StudentView{result, {}}).value());
}

TEST(JUnitXml, AlwaysHasTheSameCases) {
    std::set<std::string> names;
    for (const SubmissionResult& result :
         {passedExample(), failedBumpExample(), failedLensExample()}) {
        const ReadSuite read = readBack(result);
        EXPECT_EQ(read.cases.size(), 5U);
        for (const auto& [name, unused] : read.cases)
            names.insert(name);
    }
    EXPECT_EQ(names, (std::set<std::string>{"Tick", "T1 Bump mapping", "T2.1 Soft shadows",
                                            "T2.2 Depth of field", "Screenshot"}));
}

TEST(JUnitXml, CountsAndKindsAreThoseOfTheResult) {
    ReadSuite read = readBack(failedBumpExample());
    EXPECT_EQ(read.counts["tests"], 5);
    EXPECT_EQ(read.counts["failures"], 2);
    EXPECT_EQ(read.counts["skipped"], 2);
    EXPECT_EQ(read.cases["Tick"].kind, "failure");
    EXPECT_EQ(read.cases["T1 Bump mapping"].kind, "failure");
    EXPECT_EQ(read.cases["T2.1 Soft shadows"].kind, "skipped");
    EXPECT_EQ(read.cases["Screenshot"].kind, "passed");
    EXPECT_EQ(readBack(passedExample()).counts["failures"], 0);
}

TEST(JUnitXml, WhatWeFailedOrAPersonDecidesIsSkipped) {
    SubmissionResult result = failedBumpExample();
    result.verdict = Verdict::needsReview;
    result.tasks[0].state = TaskState::notGraded;
    EXPECT_EQ(readBack(result).cases["Tick"].kind, "skipped");
    EXPECT_EQ(readBack(result).cases["T1 Bump mapping"].kind, "skipped");
}

TEST(JUnitXml, IsAnnotatedAtTheStudentsFile) {
    const auto bump = annotationsOf(failedBumpExample());
    EXPECT_EQ(bump.at("T1 Bump mapping").file, "exercise/BumpySphere");
    EXPECT_NE(bump.at("T1 Bump mapping").message, "");
    EXPECT_EQ(bump.at("Tick").file, "tick1star") << "no file has this name: it stands alone";
    EXPECT_EQ(annotationsOf(failedLensExample()).at("T2.2 Depth of field").file,
              "exercise/Renderer");
    EXPECT_TRUE(annotationsOf(passedExample()).empty());
}

TEST(JUnitXml, IsGroupedByTheStudentsFiles) {
    EXPECT_EQ(groupsOf(failedBumpExample()),
              (std::map<std::string, std::set<std::string>>{
                  {"", {"Tick", "Screenshot"}},
                  {"tick1star.exercise/BumpySphere", {"T1 Bump mapping"}},
                  {"tick1star.exercise/Renderer", {"T2.1 Soft shadows", "T2.2 Depth of field"}}}));
}

TEST(JUnitXml, IsWellFormedWhateverAStudentWrote) {
    const std::string xml = junitXml(StudentView{hostileExample(), {}}).value();
    const ReadSuite read = readBack(xml);
    EXPECT_NE(read.cases.at("T1 Bump mapping").message.find("<script>"), std::string::npos)
        << "kept, as text";
    EXPECT_EQ(xml.find("]]>"), std::string::npos);
    EXPECT_EQ(xml.find('\x1B'), std::string::npos);
}

}  // namespace
}  // namespace ticker::report
