// sandbox_victim LEVEL TRICKS MARKER: runs the trick that sleeps, with our descriptor 3, until
// it is killed.
#include <grader/sandbox/Sandbox.h>

#include <filesystem>
#include <string_view>

int main(int count, char** words) {
    using namespace ticker::sandbox;
    if (count != 4) return 2;
    for (const Level level : {Level::namespaces, Level::ownUser, Level::sameUser, Level::none}) {
        if (toString(level) != words[1]) continue;
        const Sandbox sandbox = Sandbox::at(level);
        const std::filesystem::path program = Sandbox::makeStagingFolder() / "tricks";
        std::filesystem::copy_file(words[2], program);
        Command command;
        command.readOnly = {{program, "/tricks"}};
        command.arguments = {"/tricks", words[3], "sleep"};
        command.descriptors = {{3, 3}};
        command.limits.wallSeconds = 600;
        return sandbox.run(command).succeeded() ? 0 : 1;
    }
    return 2;
}
