// The pipelines of a Store, and which program needed them when.
#include "layer/cache/store.h"

namespace anteroom::cache {
namespace {

constexpr int64_t kRunsThatCount = 4;   // a pipeline that as many runs did without is no longer usual
constexpr int64_t kMostPrograms = 256;  // that are remembered

constexpr const char* kPutPipeline =
    "INSERT INTO pipeline(id, created, used, uses, create_us, vertex, fragment, state) "
    "VALUES(?,?,?,?,?,?,?,?)"
    " ON CONFLICT(id) DO UPDATE SET used = max(used, excluded.used), uses = max(uses, excluded.uses),"
    " create_us = excluded.create_us";
constexpr const char* kTouchPipeline = "UPDATE pipeline SET uses = uses + 1, used = ? WHERE id = ?";
constexpr const char* kColumns =
    "SELECT pipeline.id, created, pipeline.used, pipeline.uses, create_us, vertex, fragment, state FROM ";
constexpr const char* kBeginRun =
    "INSERT INTO program(id, name, runs, used) VALUES(?,?,1,?)"
    " ON CONFLICT(id) DO UPDATE SET runs = min(runs, 1000000000) + 1, used = excluded.used RETURNING runs";
constexpr const char* kUse =
    "INSERT INTO usage(program, pipeline, uses, run, place) VALUES(?,?,1,?,?) ON CONFLICT(program, pipeline)"
    " DO UPDATE SET uses = uses + 1, run = excluded.run, place = excluded.place";
constexpr const char* kPutProgram =
    "INSERT INTO program(id, name, runs, used) VALUES(?,?,?,unixepoch())"
    " ON CONFLICT(id) DO UPDATE SET runs = max(runs, excluded.runs)";
constexpr const char* kPutUsage =
    "INSERT INTO usage(program, pipeline, uses, run, place) VALUES(?,?,?,?,?) ON CONFLICT(program, pipeline)"
    " DO UPDATE SET uses = max(uses, excluded.uses), run = max(run, excluded.run), place = excluded.place";
constexpr const char* kUsage =
    "SELECT program.id, name, runs, pipeline, uses, run, place FROM usage JOIN program ON program.id = "
    "usage.program"
    " ORDER BY program.used DESC, uses DESC, place";
constexpr const char* kUsual =
    "usage JOIN program ON program.id = usage.program JOIN pipeline ON pipeline.id = usage.pipeline"
    " WHERE usage.program = ? AND usage.run > program.runs - ? ORDER BY usage.uses DESC, usage.place LIMIT ?";

PipelineRow pipelineOf(Statement& statement) {
  PipelineRow row;
  row.created = statement.number(1);
  row.used = statement.number(2);
  row.uses = statement.number(3);
  row.createMicroseconds = statement.number(4);
  row.vertex = statement.text(5);
  row.fragment = statement.text(6);
  row.state = statement.text(7);
  return row;
}

}  // namespace

bool Store::put(const PipelineRow& row) {
  Statement& statement = lazily(putPipeline_, kPutPipeline);
  if (!statement) return false;
  const int64_t numbers[] = {row.id(), row.created, row.used, row.uses, row.createMicroseconds};
  for (int i = 0; i < 5; ++i) statement.bind(1 + i, numbers[i]);
  statement.bind(6, std::string_view(row.vertex));
  statement.bind(7, std::string_view(row.fragment));
  statement.bind(8, std::string_view(row.state));
  return statement.run();
}

bool Store::touchPipeline(int64_t id, int64_t now) {
  Statement& statement = lazily(touchPipeline_, kTouchPipeline);
  if (!statement) return false;
  statement.bind(1, now);
  statement.bind(2, id);
  return statement.run();
}

bool Store::removePipeline(int64_t id) {
  Statement statement = database_.prepare("DELETE FROM pipeline WHERE id = ?");
  if (!statement) return false;
  statement.bind(1, id);
  return statement.run();
}

bool Store::visitPipelines(const VisitPipeline& visit) {
  Statement statement = database_.prepare((std::string(kColumns) + "pipeline").c_str());
  if (!statement) return false;
  int code;
  while ((code = statement.step()) == SQLITE_ROW) {
    PipelineRow row = pipelineOf(statement);
    const int64_t id = statement.number(0);
    visit(id, row, row.id() == id ? "" : "its number is not that of what it says");
  }
  return code == SQLITE_DONE;
}

bool Store::dropUsageOfNone() {
  return database_.run(
             "DELETE FROM usage WHERE pipeline NOT IN (SELECT id FROM pipeline)"
             " OR program NOT IN (SELECT id FROM program)") == SQLITE_OK;
}

int64_t Store::beginRun(const Program& program, int64_t now) {
  Statement statement = database_.prepare(kBeginRun);
  if (!statement) return 0;
  statement.bind(1, program.id);
  statement.bind(2, std::string_view(program.name));
  statement.bind(3, now);
  if (statement.step() != SQLITE_ROW) return 0;
  const int64_t run = statement.number(0);
  statement.reset();
  Statement forget = database_.prepare(
      "DELETE FROM program WHERE id NOT IN (SELECT id FROM program ORDER BY used DESC LIMIT ?)");
  if (!forget) return 0;
  forget.bind(1, kMostPrograms);
  if (!forget.run() || (database_.changes() > 0 && !dropUsageOfNone())) return 0;
  return run;
}

bool Store::use(int64_t program, int64_t pipeline, int64_t run, int64_t place) {
  Statement& statement = lazily(use_, kUse);
  if (!statement) return false;
  const int64_t numbers[] = {program, pipeline, run, place};
  for (int i = 0; i < 4; ++i) statement.bind(1 + i, numbers[i]);
  return statement.run();
}

bool Store::put(const UsageRow& row) {
  Statement& program = lazily(putProgram_, kPutProgram);
  Statement& usage = lazily(putUsage_, kPutUsage);
  if (!program || !usage) return false;
  program.bind(1, row.program.id);
  program.bind(2, std::string_view(row.program.name));
  program.bind(3, row.runs);
  const int64_t numbers[] = {row.program.id, row.pipeline, row.uses, row.run, row.place};
  for (int i = 0; i < 5; ++i) usage.bind(1 + i, numbers[i]);
  return program.run() && usage.run();
}

bool Store::visitUsage(const std::function<void(const UsageRow&)>& visit) {
  Statement statement = database_.prepare(kUsage);
  if (!statement) return false;
  int code;
  while ((code = statement.step()) == SQLITE_ROW) {
    UsageRow row;
    row.program = {statement.number(0), std::string(statement.text(1))};
    row.runs = statement.number(2);
    row.pipeline = statement.number(3);
    row.uses = statement.number(4);
    row.run = statement.number(5);
    row.place = statement.number(6);
    visit(row);
  }
  return code == SQLITE_DONE;
}

std::vector<PipelineRow> Store::usual(int64_t program, int64_t most) {
  std::vector<PipelineRow> rows;
  Statement statement = database_.prepare((std::string(kColumns) + kUsual).c_str());
  if (!statement) return rows;
  statement.bind(1, program);
  statement.bind(2, kRunsThatCount);
  statement.bind(3, most);
  while (statement.step() == SQLITE_ROW) {
    PipelineRow row = pipelineOf(statement);
    if (row.id() == statement.number(0)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace anteroom::cache
