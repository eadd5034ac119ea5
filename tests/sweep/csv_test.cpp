#include "app/export/csv.h"

#include <gtest/gtest.h>

namespace knuckle {
namespace {

TEST(Csv, CellsAreReadAsTheyWereWritten)
{
    const std::vector<std::string> cells{"", "1.5", "a, b", "\"quoted\", \"twice\"", "ends in \"", ","};
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() && cell.empty() ? "" : ",") + csvCell(cell);
    EXPECT_EQ(line, R"(,1.5,"a, b","""quoted"", ""twice""","ends in """,",")");
    EXPECT_EQ(csvCells(line), cells);
    EXPECT_EQ(csvCells("").size(), 1u);
    EXPECT_EQ(csvCell("two\nlines"), "\"two\nlines\"");
}

}  // namespace
}  // namespace knuckle
