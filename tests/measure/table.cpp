#include "tests/measure/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace measure {

namespace {

// "error rms" in "1/255": error_rms_255.
std::string key(const Column& column) {
  const std::string unit = column.unit == "%" ? "percent" : column.unit == "1/255" ? "255" : column.unit;
  std::string result = unit.empty() ? column.name : column.name + "_" + unit;
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_'; });
  return result;
}

std::string shown(const Cell& cell, const Column& column) {
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.{}f}", *number, column.digits);
  if (const auto* words = std::get_if<std::string>(&cell)) return *words;
  return "-";
}

std::string quoted(const std::string& words) {
  if (words.find_first_of(",\"\n") == words.npos) return words;
  std::string result = "\"";
  for (char c : words) result.append(c == '"' ? 2 : 1, c);
  return result + "\"";
}

// Characters that a terminal shows, of UTF-8.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// Lines of one number of cells, below each other.
class Grid {
 public:
  // Of each column whether it is set to the right.
  explicit Grid(std::vector<bool> right) : right_(std::move(right)), widths_(right_.size(), 0) {}
  void add(std::vector<std::string> line) {
    for (std::size_t i = 0; i < line.size(); ++i) widths_[i] = std::max(widths_[i], width(line[i]));
    lines_.push_back(std::move(line));
  }
  // `starts`: columns with a rule before them.
  std::string text(const std::vector<std::size_t>& starts) const {
    std::string result;
    for (const std::vector<std::string>& line : lines_) {
      std::string row;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const bool rule = std::find(starts.begin(), starts.end(), i) != starts.end();
        const std::string gap(widths_[i] - width(line[i]), ' ');
        row += rule ? " | " : i > 0 ? "  " : "";
        row += right_[i] ? gap + line[i] : line[i] + gap;
      }
      row.erase(row.find_last_not_of(' ') + 1);
      result += row + "\n";
    }
    return result;
  }

 private:
  std::vector<bool> right_;
  std::vector<std::size_t> widths_;
  std::vector<std::vector<std::string>> lines_;
};

}  // namespace

void Table::add(std::vector<Cell> row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row of a table has too few or many cells");
  rows_.push_back(std::move(row));
}

std::string Table::text() const {
  return sideBySide(columns_.size());
}

std::string Table::sideBySide(std::size_t by) const {
  std::vector<std::size_t> subject, measured;  // columns
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (!columns_[i].detail && i != by) (i < by ? subject : measured).push_back(i);
  const auto numbers = [this](std::size_t column) {
    return std::any_of(rows_.begin(), rows_.end(),
                       [column](const auto& row) { return std::holds_alternative<double>(row[column]); });
  };
  std::vector<std::string> groups;
  std::vector<std::vector<std::string>> lines;  // begin with their subject
  for (const std::vector<Cell>& row : rows_) {
    std::vector<std::string> line;
    for (std::size_t i : subject) line.push_back(shown(row[i], columns_[i]));
    auto found = std::find_if(lines.begin(), lines.end(), [&](const auto& other) {
      return by < columns_.size() && std::equal(line.begin(), line.end(), other.begin());
    });
    if (found == lines.end()) found = lines.insert(lines.end(), line);
    if (by == columns_.size()) continue;
    const std::string group = shown(row[by], columns_[by]);
    const auto place = std::find(groups.begin(), groups.end(), group);
    const auto at = subject.size() + static_cast<std::size_t>(place - groups.begin()) * measured.size();
    if (place == groups.end()) groups.push_back(group);
    if (found->size() < at + measured.size()) found->resize(at + measured.size(), "-");
    for (std::size_t i = 0; i < measured.size(); ++i)
      (*found)[at + i] = shown(row[measured[i]], columns_[measured[i]]);
  }

  std::vector<std::string> titles(subject.size()), names, units;
  std::vector<bool> right;
  std::vector<std::size_t> starts;
  const auto head = [&](std::size_t column) {
    names.push_back(columns_[column].name);
    units.push_back(columns_[column].unit.empty() ? "" : "[" + columns_[column].unit + "]");
    right.push_back(numbers(column));
  };
  for (std::size_t i : subject) head(i);
  for (const std::string& group : groups) {
    starts.push_back(names.size());
    for (std::size_t i : measured) head(i);
    titles.resize(names.size());
    if (!measured.empty()) titles[starts.back()] = group;
  }
  Grid grid(right);
  if (!groups.empty()) grid.add(titles);
  grid.add(names);
  grid.add(units);
  for (std::vector<std::string>& line : lines) {
    line.resize(names.size(), "-");
    grid.add(std::move(line));
  }
  return grid.text(starts);
}

std::string Table::csv() const {
  std::string text;
  for (std::size_t i = 0; i < columns_.size(); ++i) text += (i > 0 ? "," : "") + quoted(key(columns_[i]));
  text += "\n";
  for (const std::vector<Cell>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ",";
      if (const auto* number = std::get_if<double>(&row[i])) text += fmt::format("{:.6g}", *number);
      if (const auto* words = std::get_if<std::string>(&row[i])) text += quoted(*words);
    }
    text += "\n";
  }
  return text;
}

nlohmann::json Table::json() const {
  nlohmann::json all = nlohmann::json::array();
  for (const std::vector<Cell>& row : rows_) {
    nlohmann::json entry = nlohmann::json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (const auto* number = std::get_if<double>(&row[i])) entry[key(columns_[i])] = *number;
      if (const auto* words = std::get_if<std::string>(&row[i])) entry[key(columns_[i])] = *words;
    }
    all.push_back(std::move(entry));
  }
  return all;
}

}  // namespace measure
