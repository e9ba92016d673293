// Writes one C++ file with the reference and every entry of the catalogue's task T1, each in a
// class of its own:
//   makeCatalogue PROJECT REFERENCE_FILE OUTPUT
#include <grader/corpus/Entry.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Writes the file's text as a class member, so that many files fit into one program.
void writeClass(std::ostream& out, const std::string& name, std::string text) {
    out << "namespace raytracer {\nclass " << name << " : public ticker::tests::StandIn {\n"
        << "public:\n    using StandIn::StandIn;\n"
        << "    Vector3 getNormalAt(const Vector3& position) const override;\n};\n}\n";
    replaceAll(text, "BumpySphere::getNormalAt", name + "::getNormalAt");
    out << text << "\nnamespace {\nraytracer::Vector3 ask" << name
        << "(const ticker::selftest::Point& point) {\n    return raytracer::" << name
        << "(point).getNormalAt(point.position);\n}\n}\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return 2;
    std::ifstream referenceFile(argv[2]);
    const std::string reference{std::istreambuf_iterator<char>(referenceFile),
                                std::istreambuf_iterator<char>()};
    std::ofstream out(argv[3]);
    out << "#include <grader/tests/tasks/bump/StandIn.h>\n";
    writeClass(out, "Reference", reference);
    std::string table = "{\"reference\", \"\", \"passed\", askReference},\n";
    try {
        int number = 0;
        for (const ticker::corpus::Entry& mistake : ticker::corpus::readCatalogue(argv[1])) {
            if (mistake.group != "T1") continue;
            const std::string name = "Mistake" + std::to_string(number++);
            writeClass(out, name, ticker::corpus::textsOf(mistake).at(mistake.file()));
            table += "{\"" + mistake.name + "\", \"" + mistake.expected().finding() + "\", \"" +
                     mistake.expected().states.front() + "\", ask" + name + "},\n";
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
    out << "const std::vector<ticker::tests::CompiledMistake>& "
           "ticker::tests::compiledCatalogue() {\n"
           "    static const std::vector<CompiledMistake> all{\n"
        << table << "    };\n    return all;\n}\n";
    return out.good() && !reference.empty() ? 0 : 2;
}
