#include "io/svg_text.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

std::string escaped(std::string_view words) {
    std::string out;
    for (const char c : words) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

}  // namespace

std::string svg_number(double value) {
    check(std::isfinite(value), "a drawing has finite coordinates");
    std::string digits = fmt::format("{:.2f}", value);
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
    return digits == "-0" ? "0" : digits;
}

std::string svg_path(std::span<const SvgPoint> points) {
    std::string d;
    for (const SvgPoint& p : points)
        d += fmt::format("{}{} {}", d.empty() ? 'M' : 'L', svg_number(p.x), svg_number(p.y));
    return d;
}

SvgText::SvgText(double width, double height, std::string_view title, std::string_view style) {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\">\n<title>{2}</title>\n<style>{3}</style>\n",
        svg_number(width), svg_number(height), escaped(title), escaped(style));
}

void SvgText::start(const char* element, Attributes attributes) {
    text_ += fmt::format("<{}", element);
    write(attributes);
}

void SvgText::write(Attributes attributes) {
    for (const SvgAttribute& a : attributes) {
        const auto* number = std::get_if<double>(&a.value);
        const std::string value = number != nullptr ? svg_number(*number) : escaped(std::get<std::string>(a.value));
        text_ += fmt::format(" {}=\"{}\"", a.name, value);
    }
}

void SvgText::add(const char* element, Attributes attributes, std::string_view tip) {
    start(element, attributes);
    text_ += tip.empty() ? "/>\n" : fmt::format("><title>{}</title></{}>\n", escaped(tip), element);
}

void SvgText::text(SvgPoint at, const char* style_class, std::string_view words, Attributes more) {
    start("text", {{"x", at.x}, {"y", at.y}, {"class", style_class}});
    write(more);
    text_ += fmt::format(">{}</text>\n", escaped(words));
}

void SvgText::open(const char* element, Attributes attributes) {
    start(element, attributes);
    text_ += ">\n";
    open_.emplace_back(element);
}

void SvgText::close() {
    check(!open_.empty(), "every element of a drawing is closed once");
    text_ += fmt::format("</{}>\n", open_.back());
    open_.pop_back();
}

std::string SvgText::document() const {
    check(open_.empty(), "every element of a drawing is closed");
    return text_ + "</svg>\n";
}

}  // namespace overfly
