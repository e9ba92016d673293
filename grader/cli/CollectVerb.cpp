#include <grader/cli/Output.h>
#include <grader/cli/Verb.h>
#include <grader/report/Words.h>
#include <grader/store/ClassFolder.h>

#include <CLI/CLI.hpp>

#include <fmt/core.h>
#include <filesystem>
#include <memory>
#include <string>

namespace ticker::cli {
namespace {

raytracer::ExitCode collect(const std::string& out, const Voice& voice) {
    if (!std::filesystem::is_directory(out))
        throw raytracer::InputError(out, 0, "is no folder; expected one with results below");
    store::Store store{out};
    if (!store.notice().empty()) fmt::print(stderr, "ticker: {}\n", store.notice());
    const store::Collected collected = store::collect(out, store);
    for (const std::string& problem : collected.unreadable)
        fmt::print(stderr, "ticker: {}\n", problem);
    writeClass(out);
    if (!voice.quiet)
        fmt::print(stderr, "{} taken in, {} known already\nopen {}/index.html\n",
                   report::counted(collected.taken, "result"), collected.known, out);
    return collected.unreadable.empty() ? raytracer::ExitCode::success
                                        : raytracer::ExitCode::notGradable;
}

}  // namespace

Run addCollect(CLI::App& app, const Voice& voice) {
    auto out = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand(
        "collect", "Take in results that were written into OUT elsewhere, by a cluster's nodes");
    verb->add_option("out", *out, "Folder with <submission>/result.json files")->required();
    return [out, &voice] { return collect(*out, voice); };
}

}  // namespace ticker::cli
