#include "host_sim/flight_test/included_scripts.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "host_sim/flight_test/script_table.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

class ScriptIncluder {
public:
    explicit ScriptIncluder(ScriptFaults& faults) : faults_(faults) {}

    void read(const std::string& path, const std::string& text) {
        open_.push_back(identity_of(path));
        const std::size_t before = faults_.count();
        ScriptValue tree = parse_script_value(text, path, faults_);
        scripts_.is_broken = scripts_.is_broken || faults_.count() != before;
        ScriptTable table(tree, faults_);
        for (const std::string& name : table.texts("include")) include(table, path_from(path, name));
        take_parameters(table);
        scripts_.files.push_back(std::move(tree));
        scripts_.paths.push_back(path);
        done_.push_back(open_.back());
        open_.pop_back();
    }

    IncludedScripts take(const ScriptParameters& stated) {
        for (const auto& [name, parameter] : parameters_) scripts_.parameters.push_back(name);
        for (const auto& [name, value] : stated)
            if (parameters_.count(name) != 0) parameters_[name] = value;
        std::set<std::string> used;
        for (ScriptValue& tree : scripts_.files) put_parameters(tree, parameters_, faults_, used);
        if (!scripts_.is_broken) find_unused(used);
        return std::move(scripts_);
    }

private:
    static std::string identity_of(const std::string& path) {
        std::error_code error;
        const auto canonical = std::filesystem::weakly_canonical(path, error);
        return error ? path : canonical.string();
    }

    /// Parameters of an included file may be for others.
    void find_unused(const std::set<std::string>& used) {
        const ScriptValue* const own = scripts_.files.back().find("parameters");
        if (own == nullptr) return;
        for (const auto& [name, value] : own->entries)
            if (parameters_.count(name) != 0 && used.count(name) == 0)
                faults_.add(value.file, value.line,
                            "nothing uses the parameter '" + name + "'; write \"$" + name + "\", or remove it");
    }

    void include(ScriptTable& from, const std::string& path) {
        const std::string identity = identity_of(path);
        if (std::find(open_.begin(), open_.end(), identity) != open_.end())
            return from.fault("include", "'include': " + path + " includes this file in turn; break the circle");
        if (std::find(done_.begin(), done_.end(), identity) != done_.end()) return;
        std::string text;
        try {
            text = read_file(path);
        } catch (const UserError& error) {
            return from.fault("include", std::string("'include': ") + error.what());
        }
        read(path, text);
    }

    void take_parameters(ScriptTable& table) {
        for (const ScriptValue::Entry* const entry : table.entries("parameters")) {
            const bool is_plain =
                entry->second.kind == ScriptValue::Kind::number || entry->second.kind == ScriptValue::Kind::text;
            if (!is_plain)
                faults_.add(entry->second.file, entry->second.line, "'" + entry->first + "': a parameter is a number or a text");
            else
                parameters_[entry->first] = entry->second;
        }
    }

    ScriptFaults& faults_;
    IncludedScripts scripts_;
    ScriptParameters parameters_;
    std::vector<std::string> open_, done_;
};

}  // namespace

IncludedScripts read_included_scripts(const std::string& path, const ScriptParameters& stated, ScriptFaults& faults) {
    ScriptIncluder includer(faults);
    includer.read(path, read_file(path));
    return includer.take(stated);
}

}  // namespace tedavis::host_sim
