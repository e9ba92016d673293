#include <grader/base/MakeFolder.h>
#include <grader/lab/repairs/RepairRecord.h>

#include <grader/base/WholeFile.h>

#include <raytracer/base/Error.h>

#include <fstream>
#include <utility>

namespace ticker::lab {

RepairRecord::RepairRecord(std::filesystem::path file) : file_(std::move(file)) {
    const std::string text = readIfThere(file_).value_or("");
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', begin)) {
        const RepairRow row = rowOf(text.substr(begin, end - begin));
        rows_.insert_or_assign(nameOf(row), row);
        begin = end + 1;
    }
    if (begin < text.size()) std::filesystem::resize_file(file_, begin);
}

const RepairRow* RepairRecord::find(const std::string& name) const {
    const auto row = rows_.find(name);
    return row == rows_.end() ? nullptr : &row->second;
}

void RepairRecord::add(const RepairRow& row) {
    makeFolder(std::filesystem::absolute(file_).parent_path());
    std::ofstream stream{file_, std::ios::app | std::ios::binary};
    stream << jsonOf(row) << '\n' << std::flush;
    if (!stream) throw raytracer::InputError(file_.string(), 0, "cannot be written");
    rows_.insert_or_assign(nameOf(row), row);
}

}  // namespace ticker::lab
