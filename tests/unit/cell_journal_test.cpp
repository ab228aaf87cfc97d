#include "deploy/cell_journal.h"

#include <catch2/catch.hpp>
#include <limits>

#include "common/base/error.h"
#include "common/base/fingerprint.h"
#include "common/base/whole_file.h"
#include "tests/temporary_folder.h"

namespace ronda {
namespace {

const std::string kIdentity = R"({"seed":1,"agents":[2,4]})";

/// Numbers that are no short decimals.
const std::vector<EpisodeResult> kEpisodes{
    {.agi_s = 1.0 / 3.0,
     .wi_s = std::numeric_limits<double>::denorm_min(),
     .final_s = 0.1 + 0.2,
     .decisions = std::numeric_limits<std::int64_t>::max()},
    {.agi_s = 1e-300, .wi_s = 1e300, .final_s = 0.0, .decisions = 0}};

void CheckHolds(const CellJournal& sut, std::size_t cell) {
  const auto found = sut.Find(cell);
  REQUIRE(found);
  REQUIRE(found->size() == kEpisodes.size());
  for (std::size_t i = 0; i < kEpisodes.size(); ++i) {
    CHECK((*found)[i].agi_s == kEpisodes[i].agi_s);
    CHECK((*found)[i].wi_s == kEpisodes[i].wi_s);
    CHECK((*found)[i].final_s == kEpisodes[i].final_s);
    CHECK((*found)[i].decisions == kEpisodes[i].decisions);
  }
}

TEST_CASE("A journal gives back each cell's episodes to the last bit, also when read again") {
  const TemporaryFolder folder;
  {
    CellJournal sut(folder / "cells.jsonl", kIdentity);
    CHECK_FALSE(sut.Find(3));
    sut.Append(3, kEpisodes);
    CheckHolds(sut, 3);
  }
  const CellJournal again(folder / "cells.jsonl", kIdentity);
  CheckHolds(again, 3);
  CHECK_FALSE(again.Find(2));
}

TEST_CASE(
    "A journal that was torn anywhere is gone on with: whole lines count, the next is whole") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  CellJournal(file, kIdentity).Append(0, kEpisodes);
  const std::string whole = ReadWholeFile(file);

  for (std::size_t kept = 0; kept <= whole.size(); ++kept) {
    CAPTURE(kept);
    WriteWholeFile(file, whole.substr(0, kept));
    {
      CellJournal sut(file, kIdentity);
      CHECK(sut.Find(0).has_value() ==
            (kept + 1 >= whole.size()));  // the line's end may be missing
      sut.Append(1, kEpisodes);
    }
    CheckHolds(CellJournal(file, kIdentity), 1);
  }
}

TEST_CASE("The journal of another comparison is refused with the key that differs") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  CellJournal(file, kIdentity).Append(0, kEpisodes);
  const std::string whole = ReadWholeFile(file);

  CHECK_THROWS_AS(CellJournal(file, R"({"seed":2,"agents":[2,4]})"), UsageError);
  CHECK_THROWS_WITH(CellJournal(file, R"({"seed":1,"agents":[4,2]})"),
                    "--out must be a new folder, or that of the same comparison; in " +
                        file.string() + " 'agents' was [2,4], got [4,2]");
  CHECK(ReadWholeFile(file) == whole);
}

TEST_CASE("A journal's line that is JSON but no finished cell is refused by file and line") {
  const TemporaryFolder folder;
  const auto file = folder / "cells.jsonl";
  for (const std::string line : {R"({"time_s":1})", "[1]", R"({"cell":0,"episodes":[[1,2,3]]})"}) {
    WriteWholeFile(file, kIdentity + "\ntorn\n" + line + "\n");
    CHECK_THROWS_WITH(CellJournal(file, kIdentity),
                      Catch::StartsWith(file.string() + ":3: each line must be a finished cell"));
    CHECK_THROWS_AS(CellJournal(file, kIdentity), InputError);
  }
}

TEST_CASE("A file's fingerprint is the CRC-32 of its bytes and their number") {
  const TemporaryFolder folder;
  WriteWholeFile(folder / "file", "123456789");
  CHECK(FileFingerprint(folder / "file") == "cbf43926-9");  // the check value of CRC-32
  CHECK_THROWS_AS(FileFingerprint(folder / "none"), InputError);
}

}  // namespace
}  // namespace ronda
