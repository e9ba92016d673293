#include <grader/store/Store.h>
#include <grader/tests/support/AsNobody.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <barrier>
#include <fstream>
#include <thread>

namespace ticker::store {
namespace {

namespace fs = std::filesystem;

const std::string kNow = "2026-11-21T16:05:36Z";
const std::string kOddName = "J\xC3\xBCrgen \"<b>\" O'Neill, =1+1_12";

SubmissionResult judgedResult(const std::string& name, Verdict verdict = Verdict::notAwarded) {
    SubmissionResult result;
    result.submission = name;
    result.verdict = verdict;
    result.score = verdict == Verdict::awarded ? 1.0 : 0.0;
    result.option = "T1";
    result.toolVersion = "0.1.0";
    result.inputs = {"aa", "bb", "cc"};
    TaskReport task;
    task.id = "T1";
    for (const auto& [id, severity] :
         {std::pair{"bump.inverted-u", Severity::fail}, std::pair{"bump.mirrored", Severity::note}})
        task.findings.push_back({id, severity, "message", "", "", {}, {}, {}});
    result.tasks.push_back(task);
    return result;
}

Decision decisionOn(const std::string& name, Ruling ruling, std::int64_t version,
                    const std::string& who = "ann") {
    return {name, version, ruling, "see line 7, \"there\"", who, kNow, Verdict::needsReview};
}

TEST(Store, KeepsResultsForTheNextWhoOpensIt) {
    const tests::TemporaryFolder out;
    Store{out.path()}.put(judgedResult(kOddName), kNow);
    const Store store{out.path()};
    ASSERT_EQ(store.results().size(), 1U);
    const auto row = store.find(kOddName);
    ASSERT_TRUE(row);
    EXPECT_EQ(row->verdict, Verdict::notAwarded);
    EXPECT_EQ(row->option, "T1");
    EXPECT_EQ(row->findings, std::vector<std::string>{"bump.inverted-u"}) << "notes do not count";
    EXPECT_EQ(row->inputs, (Inputs{"aa", "bb", "cc"}));
    EXPECT_EQ(row->gradedAt, kNow);
    EXPECT_EQ(row->timesGraded, 1);
    EXPECT_FALSE(store.find("nobody"));
}

TEST(Store, CountsHowOftenASubmissionWasGradedAndKeepsTheLast) {
    const tests::TemporaryFolder out;
    Store store{out.path()};
    store.put(judgedResult("ann"), kNow);
    store.put(judgedResult("ann", Verdict::awarded), kNow);
    EXPECT_EQ(store.find("ann")->verdict, Verdict::awarded);
    EXPECT_EQ(store.find("ann")->timesGraded, 2);
}

TEST(Store, ListsResultsByName) {
    const tests::TemporaryFolder out;
    Store store{out.path()};
    for (const char* name : {"cy", "ann", "bob"})
        store.put(judgedResult(name), kNow);
    std::vector<std::string> names;
    for (const ResultRow& row : store.results())
        names.push_back(row.submission);
    EXPECT_EQ(names, (std::vector<std::string>{"ann", "bob", "cy"}));
}

TEST(Store, RemembersWhatItIsTold) {
    const tests::TemporaryFolder out;
    Store{out.path()}.remember("seed", "7");
    Store store{out.path()};
    EXPECT_EQ(store.remembered("seed"), "7");
    EXPECT_EQ(store.remembered("other"), "");
    store.remember("seed", "8");
    EXPECT_EQ(store.remembered("seed"), "8");
}

TEST(Store, KeepsEveryDecisionBesideWhatWasProposed) {
    const tests::TemporaryFolder out;
    {
        Store store{out.path()};
        EXPECT_TRUE(store.decide(decisionOn(kOddName, Ruling::awarded, 0)).isKept);
        EXPECT_TRUE(store.decide(decisionOn(kOddName, Ruling::undecided, 1, "bob")).isKept);
        EXPECT_TRUE(store.decide(decisionOn("ann", Ruling::notYet, 0)).isKept);
    }
    const Store store{out.path()};
    const std::vector<Decision> history = store.history(kOddName);
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[0].ruling, Ruling::awarded);
    EXPECT_EQ(history[0].who, "ann");
    EXPECT_EQ(history[0].when, kNow);
    EXPECT_EQ(history[0].comment, "see line 7, \"there\"");
    EXPECT_EQ(history[0].proposed, Verdict::needsReview);
    EXPECT_EQ(history[1].version, 2);
    const std::vector<Decision> newest = store.decisions();
    ASSERT_EQ(newest.size(), 2U);
    EXPECT_EQ(newest[1].submission, "ann");
    EXPECT_EQ(newest[0].who, "bob");
}

TEST(Store, KeepsCommentsOnLinesAndWhatWasDecidedInBulk) {
    const tests::TemporaryFolder out;
    Decision decision = decisionOn("ann", Ruling::notYet, 0);
    decision.notes = {{"Own.cpp", 7, "int \"x\";", "why `int`?\nsee *there*"}};
    decision.bulk = "b1";
    decision.files = "aa";
    Decision other = decisionOn("bob", Ruling::notYet, 3);
    const std::vector<DecideOutcome> outcomes = Store{out.path()}.decide({decision, other});
    ASSERT_EQ(outcomes.size(), 2U);
    EXPECT_TRUE(outcomes[0].isKept);
    EXPECT_FALSE(outcomes[1].isKept) << "the others of a bulk are kept in any case";
    const Decision kept = Store{out.path()}.decisions().at(0);
    EXPECT_EQ(kept.notes, decision.notes);
    EXPECT_EQ(kept.bulk, "b1");
    EXPECT_EQ(kept.files, "aa");
}

TEST(Store, TakesTheFileOfAnOlderTickerWithItsDecisions) {
    const tests::TemporaryFolder out;
    {
        const Database old{out.path() / "results.sqlite"};
        old.run(R"(
            CREATE TABLE class (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
            CREATE TABLE result (submission TEXT PRIMARY KEY, verdict TEXT NOT NULL,
                score REAL NOT NULL, max_score REAL NOT NULL, option TEXT NOT NULL,
                findings TEXT NOT NULL, tool_version TEXT NOT NULL, files TEXT NOT NULL,
                tool TEXT NOT NULL, how TEXT NOT NULL, graded_at TEXT NOT NULL,
                times_graded INTEGER NOT NULL) WITHOUT ROWID;
            CREATE TABLE decision (submission TEXT NOT NULL, version INTEGER NOT NULL,
                ruling TEXT NOT NULL, comment TEXT NOT NULL, who TEXT NOT NULL, at TEXT NOT NULL,
                proposed TEXT NOT NULL, PRIMARY KEY (submission, version)) WITHOUT ROWID;
            INSERT INTO decision VALUES ('ann', 1, 'awarded', 'fine', 'bo', '', 'awarded');
            PRAGMA user_version = 1;)");
    }
    Store store{out.path()};
    ASSERT_EQ(store.decisions().size(), 1U);
    EXPECT_EQ(store.decisions().at(0).comment, "fine");
    EXPECT_TRUE(store.decisions().at(0).notes.empty());
    store.put(judgedResult("ann"), kNow);
    EXPECT_EQ(store.find("ann")->tasks, std::vector<std::string>{"T1:notGraded"});
}

TEST(Store, LosesNoDecisionOfTwoWhoDecideAtOnce) {
    const tests::TemporaryFolder out;
    Store first{out.path()};
    Store second{out.path()};
    EXPECT_TRUE(first.decide(decisionOn("ann", Ruling::awarded, 0, "one")).isKept);
    const DecideOutcome late = second.decide(decisionOn("ann", Ruling::notYet, 0, "two"));
    EXPECT_FALSE(late.isKept);
    EXPECT_EQ(late.current.who, "one");
    EXPECT_EQ(late.current.ruling, Ruling::awarded);
    EXPECT_TRUE(second.decide(decisionOn("ann", Ruling::notYet, 1, "two")).isKept);
    EXPECT_EQ(first.history("ann").size(), 2U);
}

TEST(Store, LosesNoDecisionOfManyThreadsOverTwoConnections) {
    const tests::TemporaryFolder out;
    std::array<Store, 2> stores{Store{out.path()}, Store{out.path()}};
    constexpr int kThreads = 4;
    constexpr int kEach = 25;
    const auto insist = [&](int thread) {
        Store& store = stores.at(static_cast<std::size_t>(thread) % 2);
        for (int i = 0; i < kEach; ++i) {
            Decision decision = decisionOn("ann", Ruling::awarded, 0, std::to_string(thread));
            for (DecideOutcome outcome = store.decide(decision); !outcome.isKept;
                 outcome = store.decide(decision))
                decision.version = outcome.current.version;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < kThreads; ++i)
            threads.emplace_back(insist, i);
    }
    const std::vector<Decision> history = stores[0].history("ann");
    ASSERT_EQ(history.size(), static_cast<std::size_t>(kThreads * kEach));
    for (std::size_t i = 0; i < history.size(); ++i)
        EXPECT_EQ(history[i].version, static_cast<std::int64_t>(i) + 1);
}

TEST(Store, SaysSoWhereItUsesARollbackJournal) {
    const tests::TemporaryFolder out;
    EXPECT_EQ(Store{out.path()}.notice(), "");
    EXPECT_TRUE(fs::exists(out.path() / "results.sqlite"));
    const tests::TemporaryFolder shared;
    Store store{shared.path(), Journal::rollback};
    EXPECT_NE(store.notice().find("rollback journal"), std::string::npos);
    store.put(judgedResult("ann"), kNow);
    EXPECT_FALSE(fs::exists(shared.path() / "results.sqlite-wal"));
    EXPECT_EQ((Store{shared.path(), Journal::rollback}.results().size()), 1U);
}

TEST(Store, RefusesWhatIsNoStoreInOneLine) {
    const tests::TemporaryFolder out;
    out.write("results.sqlite", "this is a text, and long enough to look like something at all. " +
                                    std::string(2000, 'x'));
    EXPECT_THROW(Store{out.path()}, raytracer::InputError);
    EXPECT_THROW(Store{out.path() / "nowhere"}, raytracer::InputError);
}

std::string complaintAbout(const std::filesystem::path& out) {
    try {
        const Store store{out};
        return store.results().empty() ? "empty" : "none";
    } catch (const raytracer::InputError& error) {
        return error.what();
    }
}

TEST(Store, CanBeReadByWhoMayNotWriteItAndSaysSoToWhoTries) {
    for (const Journal journal : {Journal::writeAhead, Journal::rollback}) {
        const tests::TemporaryFolder folder;
        fs::permissions(folder.path(), fs::perms{0755});
        const fs::path out = folder.path() / "100% #1?";
        fs::create_directory(out);
        Store{out, journal}.put(judgedResult("ann"), kNow);
        fs::permissions(out / "results.sqlite", fs::perms{0444});
        fs::permissions(out, fs::perms{0555});
        const tests::AsNobody nobody;
        Store store{out};
        EXPECT_EQ(store.notice(), "");
        EXPECT_EQ(store.results().size(), 1U);
        try {
            store.put(judgedResult("bob"), kNow);
            ADD_FAILURE() << "it was written";
        } catch (const raytracer::InputError& error) {
            EXPECT_NE(std::string{error.what()}.find("results.sqlite: cannot be written; make it"),
                      std::string::npos)
                << error.what();
        }
    }
}

TEST(Store, CanBeMadeByManyAtOnce) {
    constexpr int kRounds = 20;
    constexpr int kMakers = 4;
    for (int round = 0; round < kRounds; ++round) {
        const tests::TemporaryFolder out;
        std::barrier start{kMakers};
        std::vector<std::string> complaints(kMakers);
        {
            std::vector<std::jthread> makers;
            for (std::string& complaint : complaints)
                makers.emplace_back([&] {
                    start.arrive_and_wait();
                    try {
                        const Store store{out.path()};
                    } catch (const raytracer::Error& error) {
                        complaint = error.what();
                    }
                });
        }
        EXPECT_EQ(complaints, std::vector<std::string>(kMakers));
    }
}

TEST(Store, SaysWhatToDoAboutABrokenFile) {
    const tests::TemporaryFolder out;
    out.write("results.sqlite", "this is a text, and long enough to look like something at all. " +
                                    std::string(2000, 'x'));
    const std::string complaint = complaintAbout(out.path());
    EXPECT_NE(complaint.find("results.sqlite"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("ticker collect OUT"), std::string::npos) << complaint;
    EXPECT_NE(complaint.find("decisions are in this file alone"), std::string::npos) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
}

TEST(Store, SaysWhatToDoAboutPagesThatAreDamaged) {
    const tests::TemporaryFolder out;
    { const Store store{out.path(), Journal::rollback}; }
    std::fstream file{out.path() / "results.sqlite", std::ios::in | std::ios::out};
    file.seekp(100);  // after the header: the root page of the schema
    file << std::string(3000, 'x');
    file.close();
    const std::string complaint = complaintAbout(out.path());
    EXPECT_NE(complaint.find("ticker collect OUT"), std::string::npos) << complaint;
}

TEST(Store, RefusesAnotherProgramsDatabaseAndWritesNothingIntoIt) {
    for (const char* version : {"0", "1", "7"}) {
        const tests::TemporaryFolder out;
        const std::filesystem::path file = out.path() / "results.sqlite";
        Database{file}.run("CREATE TABLE bookmark (url TEXT)");
        Database{file}.run(std::string{"PRAGMA user_version = "} + version);
        const std::string before = tests::readFile(file.string());
        const std::string complaint = complaintAbout(out.path());
        EXPECT_NE(complaint.find("another program"), std::string::npos) << complaint;
        EXPECT_EQ(tests::readFile(file.string()), before) << version;
    }
}

TEST(Store, RefusesANewerTickersStore) {
    const tests::TemporaryFolder out;
    { const Store store{out.path()}; }
    Database{out.path() / "results.sqlite"}.run("PRAGMA user_version = 99");
    EXPECT_THROW(Store{out.path()}, raytracer::InputError);
}

}  // namespace
}  // namespace ticker::store
