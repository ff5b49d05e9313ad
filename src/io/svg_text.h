#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace overfly {

struct SvgPoint {
    double x = 0.0, y = 0.0;
};

// name="value"; numbers are written with two decimals at most, which is finer than anyone draws.
struct SvgAttribute {
    const char* name;
    std::variant<double, std::string> value;
};

// An SVG drawing as text: elements one after another, groups within each other. Names and attributes are the format's
// own (Scalable Vector Graphics 1.1). What the caller gives as values and text is escaped.
class SvgText {
  public:
    // style: a style sheet for the classes that elements name.
    SvgText(double width, double height, std::string_view title, std::string_view style);

    using Attributes = std::initializer_list<SvgAttribute>;
    // tip: what viewers show where the pointer is.
    void add(const char* element, Attributes attributes, std::string_view tip = {});
    void text(SvgPoint at, const char* style_class, std::string_view words, Attributes more = {});
    void open(const char* element, Attributes attributes);
    void close();

    // The whole document. REQUIRES: all that was opened is closed.
    [[nodiscard]] std::string document() const;

  private:
    void start(const char* element, Attributes attributes);
    void write(Attributes attributes);

    std::string text_;
    std::vector<std::string> open_;
};

[[nodiscard]] std::string svg_number(double value);
// The value of a `d` attribute: straight lines from point to point. Empty for no points.
[[nodiscard]] std::string svg_path(std::span<const SvgPoint> points);

}  // namespace overfly
