#include <grader/base/Utf8.h>
#include <grader/result/Names.h>
#include <grader/result/RayDrawingJson.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace ticker {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::pair<RayDrawing::Kind, std::string_view>, 4> kRayKindNames{
    {{RayDrawing::Kind::camera, "camera"},
     {RayDrawing::Kind::arrives, "arrives"},
     {RayDrawing::Kind::blocked, "blocked"},
     {RayDrawing::Kind::expected, "expected"}}};

/// Rounded to 1e-4: drawings show no more.
double roundedLength(double value) {
    constexpr double kScale = 1e4;
    return std::isfinite(value) ? std::round(value * kScale) / kScale : 0.0;
}

ordered_json pointJson(const RayDrawing::Point& point) {
    return {roundedLength(point[0]), roundedLength(point[1]), roundedLength(point[2])};
}

ordered_json ballJson(const RayDrawing::Ball& ball) {
    return {{"name", cleanText(ball.name)},
            {"colour", "#808890"},
            {"centre", pointJson(ball.centre)},
            {"radius", roundedLength(ball.radius)}};
}

ordered_json rayJson(const RayDrawing::Ray& ray) {
    return {{"k", nameIn(kRayKindNames, ray.kind)},
            {"a", pointJson(ray.from)},
            {"b", pointJson(ray.to)},
            {"t", cleanText(ray.words)},
            {"p", -1},
            {"l", ray.light}};
}

ordered_json normalJson(const RayDrawing::Normal& normal) {
    ordered_json json{{"at", pointJson(normal.at)},
                      {"smooth", pointJson(normal.smooth)},
                      {"given", pointJson(normal.given)}};
    if (normal.expected) json["expected"] = pointJson(*normal.expected);
    return json;
}

template <typename Item, typename Convert>
ordered_json arrayOf(const std::vector<Item>& items, const Convert& convert) {
    ordered_json array = ordered_json::array();
    for (const Item& item : items)
        array.push_back(convert(item));
    return array;
}

RayDrawing::Point readPoint(const JsonValue& place) {
    const std::vector<JsonValue> numbers = place.items();
    if (numbers.size() != 3) place.expect("three numbers");
    return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

RayDrawing::Ball readBall(const JsonValue& place) {
    return {place.at("name").text(), readPoint(place.at("centre")), place.at("radius").number()};
}

RayDrawing::Ray readRay(const JsonValue& place) {
    const auto kind = valueIn(kRayKindNames, place.at("k").text());
    if (!kind) place.at("k").expect("camera, arrives, blocked or expected");
    const double light = place.at("l").number();
    if (!(light >= -1.0 && light < 1e6)) place.at("l").expect("the index of a light, or -1");
    return {*kind, readPoint(place.at("a")), readPoint(place.at("b")), place.at("t").text(),
            static_cast<int>(light)};
}

RayDrawing::Normal readNormal(const JsonValue& place) {
    RayDrawing::Normal normal{
        readPoint(place.at("at")), readPoint(place.at("smooth")), {}, readPoint(place.at("given"))};
    if (place.has("expected")) normal.expected = readPoint(place.at("expected"));
    return normal;
}

std::vector<RayDrawing::Point> readLine(const JsonValue& place) {
    std::vector<RayDrawing::Point> line;
    for (const JsonValue& point : place.items())
        line.push_back(readPoint(point));
    return line;
}

}  // namespace

std::string rayDrawingJson(const RayDrawing& drawing) {
    ordered_json json;
    json["about"] = cleanText(drawing.about);
    json["words"] = arrayOf(drawing.words, [](const std::string& line) { return cleanText(line); });
    json["spheres"] = arrayOf(drawing.spheres, ballJson);
    json["planes"] = arrayOf(drawing.planes, [](const RayDrawing::Sheet& sheet) {
        return ordered_json{{"name", cleanText(sheet.name)},
                            {"point", pointJson(sheet.point)},
                            {"normal", pointJson(sheet.normal)}};
    });
    json["lights"] = arrayOf(drawing.lights, ballJson);
    if (drawing.lensHalfWidth >= 0.0)
        json["lens"] = {{"halfWidth", roundedLength(drawing.lensHalfWidth)}};
    if (drawing.focalPlane > 0.0) json["focalPlane"] = roundedLength(drawing.focalPlane);
    json["rays"] = arrayOf(drawing.rays, rayJson);
    if (!drawing.normals.empty()) json["normals"] = arrayOf(drawing.normals, normalJson);
    if (!drawing.outlines.empty())
        json["outlines"] = arrayOf(
            drawing.outlines,
            [](const std::vector<RayDrawing::Point>& line) { return arrayOf(line, pointJson); });
    std::string text = json.dump(-1, ' ', true);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
        text.replace(at, 1, "\\u003c");
    return text;
}

RayDrawing readRayDrawing(const JsonValue& place) {
    RayDrawing drawing;
    drawing.about = place.at("about").text();
    for (const JsonValue& line : place.at("words").items())
        drawing.words.push_back(line.text());
    for (const JsonValue& ball : place.at("spheres").items())
        drawing.spheres.push_back(readBall(ball));
    for (const JsonValue& sheet : place.at("planes").items())
        drawing.planes.push_back(
            {sheet.at("name").text(), readPoint(sheet.at("point")), readPoint(sheet.at("normal"))});
    for (const JsonValue& ball : place.at("lights").items())
        drawing.lights.push_back(readBall(ball));
    if (place.has("lens")) drawing.lensHalfWidth = place.at("lens").at("halfWidth").number();
    if (place.has("focalPlane")) drawing.focalPlane = place.at("focalPlane").number();
    for (const JsonValue& ray : place.at("rays").items())
        drawing.rays.push_back(readRay(ray));
    if (place.has("normals"))
        for (const JsonValue& normal : place.at("normals").items())
            drawing.normals.push_back(readNormal(normal));
    if (place.has("outlines"))
        for (const JsonValue& line : place.at("outlines").items())
            drawing.outlines.push_back(readLine(line));
    return drawing;
}

}  // namespace ticker
