/// A table [[layer]] of a scene file as text, line by line.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/json_text.hpp"
#include "host_sim/printed_text.hpp"

namespace tedavis::host_sim {

class BlockText {
public:
    void line(const std::string& text) { text_ += text + "\n"; }
    void comment(const std::string& text) { line("# " + text); }
    void text(const char* key, const std::string& value) { line(std::string(key) + " = " + json_text(nlohmann::json(value))); }
    void number(const char* key, double value) { line(std::string(key) + " = " + number_text(value)); }
    void numbers(const char* key, const std::vector<double>& values) {
        std::string list;
        for (const double value : values) list += (list.empty() ? "" : ", ") + number_text(value);
        line(std::string(key) + " = [" + list + "]");
    }
    void texts(const char* key, const std::vector<std::string>& values) {
        line(std::string(key) + " = " + json_text(nlohmann::json(values)));
    }
    [[nodiscard]] const std::string& str() const { return text_; }

    /// With as many digits as a float needs.
    [[nodiscard]] static std::string number_text(double value) { return printed("%.9g", value); }

private:
    std::string text_;
};

}  // namespace tedavis::host_sim
