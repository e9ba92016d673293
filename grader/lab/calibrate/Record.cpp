#include <grader/lab/calibrate/Record.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <utility>

namespace ticker::calibrate {
namespace {

using nlohmann::json;

void write(const std::filesystem::path& file, std::ios::openmode mode, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream stream{file, mode | std::ios::binary};
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

std::string Record::lineOf(std::size_t unit, const std::string& found) const {
    return fmt::format("{{\"unit\":{},\"found\":{}}}\n", json(unitNames_.at(unit)).dump(), found);
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
    std::size_t whole = header().size();
    for (std::size_t end = text.find('\n', whole); end != std::string::npos;
         end = text.find('\n', whole)) {
        const json line = json::parse(text.substr(whole, end - whole), nullptr, false);
        if (line.is_discarded() || !line.contains("unit") || !line.contains("found")) break;
        const auto unit = units.find(line["unit"].get<std::string>());
        if (unit != units.end()) found_.insert_or_assign(unit->second, line["found"].dump());
        whole = end + 1;
    }
    if (whole < text.size()) std::filesystem::resize_file(file_, whole);
}

void Record::add(std::size_t unit, const std::string& found) {
    const std::lock_guard lock{mutex_};
    const bool first = !std::filesystem::exists(file_);
    write(file_, std::ios::app, (first ? header() : "") + lineOf(unit, found));
    found_.insert_or_assign(unit, found);
}

std::string Record::at(std::size_t unit) const {
    const auto found = found_.find(unit);
    return found == found_.end() ? "" : found->second;
}

std::vector<std::string> Record::all() const {
    std::vector<std::string> lines;
    for (const auto& [unit, found] : found_)
        lines.push_back(found);
    return lines;
}

void Record::copyTo(const std::filesystem::path& folder) const {
    std::string text = header();
    for (const auto& [unit, found] : found_)
        text += lineOf(unit, found);
    write(folder / file_.filename(), std::ios::trunc, text);
}

}  // namespace ticker::calibrate
