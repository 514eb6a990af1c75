// What was measured, for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace measure {

struct Column {
  std::string name;
  std::string unit = {};  // of its numbers: "ms", "1/255", "%"; empty: words or a plain count
  int digits = 0;         // of numbers, behind the point
  bool detail = false;    // for programs only: no place in text
};

// Nothing, a number or words. Words may stand where a number is missing, to say why.
using Cell = std::variant<std::monostate, double, std::string>;

class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}
  // A cell for each column. Throws std::logic_error when there are more or fewer.
  void add(std::vector<Cell> row);
  bool empty() const { return rows_.empty(); }

  // A line a row, below names and units.
  std::string text() const;
  // A line for each row of the columns before `by`; the columns behind it stand side by side, once for each
  // value of column `by`, in the order in which these come.
  std::string sideBySide(std::size_t by) const;
  // A line a row, below the names with their units: "median_ms".
  std::string csv() const;
  // An object a row by the same names; cells that hold nothing are left out.
  nlohmann::json json() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace measure
