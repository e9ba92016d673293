#include <grader/repair/candidates/Scope.h>
#include <grader/repair/candidates/Vocabulary.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace ticker::candidates {
namespace {

constexpr std::size_t kMostVariables = 5;

/// Whether an expression of the function names a variable.
bool isNamed(const Tree& tree, int function, int variable) {
    for (int i = variable + 1; i < static_cast<int>(tree.nodes.size()); ++i) {
        if (!tree.at(function).range.holds(tree.at(i).range)) return false;
        if (tree.at(i).kind == NodeKind::name && tree.at(i).declared == tree.at(variable).declared)
            return true;
    }
    return false;
}

/// Text of a double's initialiser with every + written as -, so that the two roots of a quadratic
/// compare equal; empty for other declarations.
std::string computation(const Edits& edits, int variable) {
    const Node& node = edits.tree().at(variable);
    if (node.kind != NodeKind::declaration || node.type != "double" || node.children.empty())
        return "";
    std::string text;
    for (const Range& token : edits.source().tokensIn(edits.tree().at(node.children.back()).range))
        text += edits.source().in(token) == "+" ? "-" : edits.source().in(token);
    return text;
}

bool isAngle(const std::string& computed) {
    for (const char* function : {"acos(", "asin(", "atan(", "atan2("})
        if (computed.find(function) != std::string::npos) return true;
    return false;
}

}  // namespace

Vocabulary::Vocabulary(const Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const int function = outermostFunction(tree, index);
    if (function < 0) return;
    const std::string_view used = edits.source().in(tree.at(function).range);
    for (const Quantity& own : tree.at(function).parts)
        addPart(own, used);
    for (const Quantity& constant : tree.constants) {
        addPart(constant, used);
        if (constant.type == "double" && used.find(constant.text) == std::string_view::npos)
            constants_.push_back(constant.text);
    }
    std::map<std::string, std::string> computed;
    for (const int variable : visibleVariables(tree, index)) {
        if (const std::string how = computation(edits, variable); !how.empty()) {
            const auto [other, isFirst] = computed.emplace(how, tree.at(variable).name);
            if (isAngle(how)) angles_.push_back(tree.at(variable).name);
            if (!isFirst) twins_.emplace_back(other->second, tree.at(variable).name);
        }
        const Node& node = tree.at(variable);
        for (const Quantity& part : node.parts)
            if (!edits.isVector(variable))
                addPart({node.name + part.text, part.type, part.argument}, used);
        variables_.push_back({node.name, node.type, !isNamed(tree, function, variable)});
    }
}

void Vocabulary::addPart(const Quantity& part, std::string_view used) {
    if (!part.argument.empty()) {
        methods_.push_back(part);
        return;
    }
    if (part.type == "raytracer::Vector3") points_.push_back(part.text);
    if (part.type == "raytracer::ColourRGB") colours_.push_back(part.text);
    if (part.type == "double") numbers_.push_back(part.text);
    if (used.find(part.text) == std::string_view::npos) unused_.push_back(part);
}

std::vector<std::string> Vocabulary::variables(std::string_view type) const {
    std::vector<std::string> texts;
    for (auto variable = variables_.rbegin();
         variable != variables_.rend() && texts.size() < kMostVariables; ++variable)
        if (variable->type == type) texts.push_back(variable->name);
    return texts;
}

std::vector<std::string> Vocabulary::idle(std::string_view type) const {
    std::vector<std::string> texts;
    for (const Variable& variable : variables_)
        if (variable.type == type && variable.isIdle) texts.push_back(variable.name);
    return texts;
}

std::vector<std::string> Vocabulary::unused(std::string_view type) const {
    std::vector<std::string> texts;
    for (const Quantity& quantity : unused_)
        if (quantity.type == type) texts.push_back(quantity.text);
    return texts;
}

std::vector<std::string> Vocabulary::places() const {
    std::vector<std::string> texts = variables("raytracer::Vector3");
    texts.insert(texts.end(), points_.begin(), points_.end());
    return texts;
}

std::vector<std::string> Vocabulary::points() const {
    std::vector<std::string> texts = places();
    std::ranges::move(calls("raytracer::Vector3"), std::back_inserter(texts));
    return texts;
}

std::vector<std::string> Vocabulary::colours() const {
    std::vector<std::string> texts = variables("raytracer::ColourRGB");
    texts.insert(texts.end(), colours_.begin(), colours_.end());
    return texts;
}

std::vector<std::string> Vocabulary::lengths() const {
    std::vector<std::string> texts;
    for (const std::string& vector : variables("raytracer::Vector3"))
        texts.push_back(vector + ".magnitude()");
    return texts;
}

std::vector<std::string> Vocabulary::calls(std::string_view type) const {
    std::vector<std::string> texts;
    for (const Quantity& method : methods_) {
        if (method.type != type) continue;
        std::vector<std::string> arguments = variables(method.argument);
        if (method.argument == "double")
            std::ranges::move(lengths(), std::back_inserter(arguments));
        for (const std::string& argument : arguments)
            texts.push_back(method.text + "(" + argument + ")");
    }
    return texts;
}

std::vector<std::string> Vocabulary::functions(std::string_view type) const {
    std::vector<std::string> texts;
    for (const Quantity& method : methods_)
        if (method.type == type) texts.push_back(method.text);
    return texts;
}

std::vector<std::string> Vocabulary::all(std::string_view type) const {
    std::vector<std::string> texts = variables(type);
    std::ranges::move(unused(type), std::back_inserter(texts));
    std::ranges::move(calls(type), std::back_inserter(texts));
    return texts;
}

}  // namespace ticker::candidates
