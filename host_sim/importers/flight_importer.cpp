#include "host_sim/importers/flight_importer.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include "host_sim/importers/adsb_json_importer.hpp"
#include "host_sim/importers/csv_importer.hpp"
#include "host_sim/importers/gpx_importer.hpp"
#include "host_sim/importers/igc_importer.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](unsigned char x, unsigned char y) {
               return std::tolower(x) == std::tolower(y);
           });
}

/// An IGC file starts with its manufacturer's A record or a header record; both lines hold no comma.
bool looks_like_igc(std::string_view text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const bool record =
        line.size() > 3 && (line[0] == 'A' || line.substr(0, 2) == "HF") && line.find(',') == std::string_view::npos;
    return record && text.find("\nB") != std::string_view::npos;
}

/// As candump -l and -L write it: "(seconds.fraction) interface identifier#data".
bool looks_like_bus_log(std::string_view text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t stamp_end = line.find(')');
    return line.front() == '(' && stamp_end != std::string_view::npos && line.find('#', stamp_end) != std::string_view::npos;
}

/// Of a file that is no table: the format that its name promises; nothing for other names.
std::string promised_format(std::string path) {
    std::transform(path.begin(), path.end(), path.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::filesystem::path name(path);
    if (name.extension() == ".gz") name = name.stem();
    const std::string extension = name.extension().string();
    if (extension == ".igc") return "IGC";
    if (extension == ".gpx") return "GPX";
    return extension == ".json" ? "ADS-B JSON" : "";
}

/// A table's first line names two columns or more.
bool looks_like_table(std::string_view text) {
    return text.substr(0, text.find('\n')).find_first_of(",;\t") != std::string_view::npos;
}

std::string choices(const ImportedFile& file) {
    std::string list;
    for (const RecordedFlight& flight : file.flights) {
        list += (list.empty() ? "" : ", ") + flight.aircraft;
        if (!flight.callsign.empty()) list += " (" + flight.callsign + ")";
    }
    return list;
}

/// Of a plain or a gzip file, from its first printed character on; empty where it cannot be read.
std::string beginning_of(const std::string& path) {
    std::string text(std::size_t{64} << 10, ' ');
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);  // it reads plain files, too
    const int count = file != nullptr ? gzread(file.get(), text.data(), static_cast<unsigned>(text.size())) : 0;
    text.resize(static_cast<std::size_t>(std::max(count, 0)));
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    return start == std::string::npos ? std::string() : text.substr(start);
}

}  // namespace

ImportedFile import_flight_file(const std::string& path) {
    const std::string content = read_file_unpacked(path);
    std::string_view text = content;
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) text.remove_prefix(kByteOrderMark.size());
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos)
        throw UserError(path + ": the file is empty; give an IGC, GPX, ADS-B JSON or CSV flight");
    if (text.find('\0') != std::string_view::npos)
        throw UserError(path + ": binary data; give an IGC, GPX, ADS-B JSON or CSV flight");
    const char first = text[start];
    if (looks_like_bus_log(text.substr(start)))
        throw UserError(path + ": a bus log already; give it to 'tedavis replay' as it is");
    if (first == '<') return import_gpx(text, path);
    if (first == '[' || first == '{') return import_adsb_json(text, path);
    if (looks_like_igc(text.substr(start))) return import_igc(text, path);
    const std::string format = promised_format(path);
    if (!format.empty() && !looks_like_table(text.substr(start)))
        throw UserError(path + ": is not the " + format + " flight that its name promises" +
                        (format == "IGC" ? ", which begins with a line A... and has lines B... of fixes" : "") +
                        "; give the file as it was recorded");
    return import_csv(text, path);
}

std::string recorded_format(const std::string& path) {
    const std::string beginning = beginning_of(path);
    if (beginning.empty() || beginning.find('\0') != std::string::npos) return {};
    if (beginning[0] == '<') return "GPX";
    if (beginning[0] == '[' || beginning[0] == '{') return "ADS-B JSON";
    return looks_like_igc(beginning) ? "IGC" : "";
}

bool is_bus_log_file(const std::string& path) {
    require_regular_file(path);
    return looks_like_bus_log(beginning_of(path));
}

RecordedFlight choose_aircraft(ImportedFile file, const std::string& aircraft, const std::string& path) {
    if (aircraft.empty()) {
        if (file.flights.size() == 1) return std::move(file.flights[0]);
        throw UserError(path + ": holds " + std::to_string(file.flights.size()) +
                        " aircraft; choose one with --aircraft: " + choices(file));
    }
    for (RecordedFlight& flight : file.flights) {
        if (equal_ignoring_case(flight.aircraft, aircraft) || equal_ignoring_case(flight.callsign, aircraft))
            return std::move(flight);
    }
    const std::string names = choices(file);
    throw UserError(path + ": no aircraft '" + aircraft + "'; " +
                    (names.empty() ? "leave out --aircraft, it names none" : "choose one with --aircraft: " + names));
}

}  // namespace tedavis::host_sim
