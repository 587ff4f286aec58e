/// A catalogue of a written database with everything at hand, and of what a test says is in memory.
#pragma once

#include <functional>
#include <set>

#include "render_core/terrain/chunk_catalogue.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::test_support {

class ResidentTdb : public terrain::ChunkCatalogue {
public:
    explicit ResidentTdb(const WrittenTdb& written) : written_(written) {}
    [[nodiscard]] const terrain::Lattice& lattice() const override { return written_.lattice(); }
    [[nodiscard]] terrain::FoundEntry find(const terrain::ChunkKey& key) override {
        if (is_missing && is_missing(key)) return {nullptr, terrain::EntryState::missing};
        if (!written_.has(key)) return {};
        return {&written_.entry(key), terrain::EntryState::present};
    }
    [[nodiscard]] terrain::SlotIndex available_slot(const terrain::ChunkKey& key) const override {
        return is_available && !is_available(key) ? terrain::kNoSlot : terrain::SlotIndex{0};
    }
    std::function<bool(const terrain::ChunkKey&)> is_missing;    ///< its directory page; null: none
    std::function<bool(const terrain::ChunkKey&)> is_available;  ///< its payload; null: all

private:
    const WrittenTdb& written_;
};

}  // namespace tedavis::test_support
