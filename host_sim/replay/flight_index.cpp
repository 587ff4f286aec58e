#include "host_sim/replay/flight_index.hpp"

#include <utility>

#include "host_sim/replay/byte_stream.hpp"

namespace tedavis::host_sim {
namespace {

constexpr char kMagic[] = "TEDAVIS flight index 5\n";

std::vector<PackedCheckpoint> get_checkpoints(ByteReader& reader) {
    std::vector<PackedCheckpoint> checkpoints;
    for (auto left = reader.get<std::uint64_t>(); left > 0 && reader.good(); --left) {
        PackedCheckpoint checkpoint;
        checkpoint.reached = reader.get<base::Time>();
        checkpoint.log_offset = reader.get<std::uint64_t>();
        checkpoint.steps_run = reader.get<std::uint64_t>();
        checkpoint.bytes = reader.get_text();
        checkpoints.push_back(std::move(checkpoint));
    }
    return checkpoints;
}

std::vector<bus::LineReport> get_reports(ByteReader& reader) {
    std::vector<bus::LineReport> reports;
    for (auto left = reader.get<std::uint64_t>(); left > 0 && reader.good(); --left) {
        const auto line = reader.get<std::uint64_t>();
        reports.push_back({line, reader.get<bus::LineFault>()});
    }
    return reports;
}

std::vector<LogInterface> get_interfaces(ByteReader& reader) {
    std::vector<LogInterface> interfaces;
    for (auto left = reader.get<std::uint64_t>(); left > 0 && reader.good(); --left) {
        const std::string name(reader.get_text());
        interfaces.push_back({name, reader.get<std::uint64_t>()});
    }
    return interfaces;
}

void put_facts(const LogFacts& facts, ByteWriter& writer) {
    writer.put(facts.first);
    writer.put(facts.last);
    writer.put(facts.counters);
    writer.put(facts.decoder);
    writer.put(facts.lines);
    writer.put(facts.broken_lines);
    writer.put(facts.has_position);
    writer.put(std::uint64_t{facts.reports.size()});
    for (const bus::LineReport& report : facts.reports) {
        writer.put(report.line);
        writer.put(report.fault);
    }
    writer.put(std::uint64_t{facts.interfaces.size()});
    for (const LogInterface& one : facts.interfaces) {
        writer.put_text(one.name);
        writer.put(one.frames);
    }
}

LogFacts get_facts(ByteReader& reader) {
    LogFacts facts;
    facts.first = reader.get<base::Time>();
    facts.last = reader.get<base::Time>();
    facts.counters = reader.get<bus::BusCounters>();
    facts.decoder = reader.get<bus::DecoderCounts>();
    facts.lines = reader.get<bus::LogLineCounts>();
    facts.broken_lines = reader.get<std::uint64_t>();
    facts.has_position = reader.get<bool>();
    facts.reports = get_reports(reader);
    facts.interfaces = get_interfaces(reader);
    return facts;
}

template <class T>
void put_list(const std::vector<T>& list, ByteWriter& writer) {
    writer.put(std::uint64_t{list.size()});
    for (const T& one : list) writer.put(one);
}

template <class T>
std::vector<T> get_list(ByteReader& reader) {
    std::vector<T> list;
    for (auto left = reader.get<std::uint64_t>(); left > 0 && reader.good(); --left) list.push_back(reader.get<T>());
    return list;
}

void put_outline(const FlightOutline& outline, ByteWriter& writer) {
    writer.put(outline.stride());
    put_list(outline.places(), writer);
    put_list(outline.phase_changes(), writer);
}

FlightOutline get_outline(ByteReader& reader) {
    const auto stride = reader.get<std::int64_t>();
    auto places = get_list<OutlinePlace>(reader);
    return {stride, std::move(places), get_list<base::Time>(reader)};
}

}  // namespace

std::string pack_index(const FlightIndex& index, const IndexKey& key) {
    ByteWriter writer;
    writer.put(kMagic);
    writer.put(std::uint64_t{sizeof(FlightProgress)});
    writer.put(key);
    put_facts(index.facts, writer);
    writer.put(index.track.stride());
    writer.put(std::uint64_t{index.track.checkpoints().size()});
    for (const PackedCheckpoint& checkpoint : index.track.checkpoints()) {
        writer.put(checkpoint.reached);
        writer.put(checkpoint.log_offset);
        writer.put(checkpoint.steps_run);
        writer.put_text(checkpoint.bytes);
    }
    put_outline(index.outline, writer);
    writer.put(checksum_of(writer.bytes()));
    return writer.take();
}

UnpackedIndex unpack_index(std::string_view bytes, const IndexKey& key, const CheckpointSpacing& spacing) {
    constexpr std::size_t kSumBytes = sizeof(std::uint64_t);
    const std::string_view magic(kMagic, sizeof kMagic);
    if (bytes.substr(0, magic.size()) != magic) return {{}, "is no index of this program version"};
    if (bytes.size() < magic.size() + kSumBytes) return {{}, "is cut off"};
    const std::string_view body = bytes.substr(0, bytes.size() - kSumBytes);
    if (ByteReader(bytes.substr(body.size())).get<std::uint64_t>() != checksum_of(body)) return {{}, "is damaged or cut off"};
    ByteReader reader(body.substr(magic.size()));
    if (reader.get<std::uint64_t>() != sizeof(FlightProgress)) return {{}, "was made by another build of the program"};
    if (const char* other = first_difference(reader.get<IndexKey>(), key))
        return {{}, std::string("was made when ") + other + " was another"};
    FlightIndex index;
    index.facts = get_facts(reader);
    const auto stride = reader.get<std::uint64_t>();
    index.track = CheckpointTrack(spacing, stride, get_checkpoints(reader));
    index.outline = get_outline(reader);
    if (!reader.good() || reader.left() != 0 || index.track.checkpoints().empty()) return {{}, "is damaged"};
    return {std::move(index), {}};
}

}  // namespace tedavis::host_sim
