#include <grader/lab/calibrate/Record.h>

#include <grader/base/MakeFolder.h>
#include <grader/base/WholeFile.h>
#include <grader/lab/calibrate/Document.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <utility>

namespace ticker::calibrate {
namespace {

using nlohmann::json;

void append(const std::filesystem::path& file, const std::string& text) {
    makeFolder(file.parent_path());
    std::ofstream stream{file, std::ios::app | std::ios::binary};
    stream << text << std::flush;
    if (!stream) throw raytracer::InputError(file.string(), 0, "cannot be written");
}

}  // namespace

Record::Record(const std::filesystem::path& folder, const Campaign& campaign)
    : file_(folder / (campaign.name() + ".jsonl")), name_(campaign.name()) {
    for (std::size_t unit = 0; unit < campaign.units(); ++unit)
        unitNames_.push_back(campaign.unitName(unit));
    if (std::filesystem::exists(file_)) read();
}

std::string Record::header() const {
    return fmt::format("{{\"campaign\":\"{}\"}}\n", name_);
}

std::string Record::lineOf(std::size_t unit, const Line& line) const {
    return fmt::format("{{\"unit\":{},\"code\":{},\"found\":{}}}\n",
                       json(unitNames_.at(unit)).dump(), json(line.stamp).dump(), line.found);
}

void Record::read() {
    const std::string text = readWhole(file_);
    if (text.compare(0, header().size(), header()) != 0)
        throw raytracer::InputError(file_.string(), 1,
                                    "is the record of another campaign, or of an older one: " +
                                        header() + "was expected; delete it to begin anew");
    std::map<std::string, std::size_t> units;
    for (std::size_t unit = 0; unit < unitNames_.size(); ++unit)
        units.emplace(unitNames_[unit], unit);
    std::size_t begin = header().size();
    int number = 1;
    for (std::size_t end = text.find('\n', begin); end != std::string::npos;
         end = text.find('\n', begin)) {
        auto [name, line] = readLine(text.substr(begin, end - begin), ++number);
        const auto unit = units.find(name);
        if (unit != units.end()) found_.insert_or_assign(unit->second, std::move(line));
        begin = end + 1;
    }
    if (begin < text.size()) wholeBytes_ = begin;
}

std::pair<std::string, Record::Line> Record::readLine(const std::string& text, int number) const {
    try {
        const json line = json::parse(text);
        return {line.at("unit").get<std::string>(),
                {line.at("found").dump(), line.value("code", Stamp{})}};
    } catch (const json::exception& error) {
        throw raytracer::InputError(file_.string(), number,
                                    std::string{"is no unit of a record: "} + error.what());
    }
}

void Record::add(std::size_t unit, const std::string& found, const Stamp& stamp) {
    const std::lock_guard lock{mutex_};
    if (wholeBytes_) std::filesystem::resize_file(file_, *std::exchange(wholeBytes_, {}));
    const bool first = !std::filesystem::exists(file_);
    const Line line{found, stamp};
    append(file_, (first ? header() : "") + lineOf(unit, line));
    found_.insert_or_assign(unit, line);
}

void Record::adopt(const Record& other, const std::vector<Stamp>& stamps) {
    for (const auto& [unit, line] : other.found_)
        if (!isCurrent(unit, stamps.at(unit)) && (line.stamp == stamps.at(unit) || !has(unit)))
            found_.insert_or_assign(unit, line);
}

std::string Record::at(std::size_t unit) const {
    const auto found = found_.find(unit);
    return found == found_.end() ? "" : found->second.found;
}

Stamp Record::stampOf(std::size_t unit) const {
    const auto found = found_.find(unit);
    return found == found_.end() ? Stamp{} : found->second.stamp;
}

bool Record::isCurrent(std::size_t unit, const Stamp& stamp) const {
    return has(unit) && stampOf(unit) == stamp;
}

std::vector<std::string> Record::all() const {
    std::vector<std::string> lines;
    for (const auto& [unit, line] : found_)
        lines.push_back(line.found);
    return lines;
}

void Record::copyTo(const std::filesystem::path& folder) const {
    std::string text = header();
    for (const auto& [unit, line] : found_)
        text += lineOf(unit, line);
    makeFolder(folder);
    writeIfChanged(text, folder / file_.filename());
}

}  // namespace ticker::calibrate
