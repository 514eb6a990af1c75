// The file of the shader cache: rows, and whether they can be believed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "layer/cache/database.h"
#include "layer/cache/rows.h"

namespace anteroom::cache {

// Older: only for a reader; who may write brings the file up to date.
enum class Opened { Ok, Missing, Foreign, Older, Newer, Damaged, Unusable };
enum class Found { Hit, Absent, Bad, Error };

// One connection, for one thread at a time.
class Store {
 public:
  enum class Mode { Read, Write, Create };
  Opened open(const std::string& path, Mode mode, int timeoutMilliseconds = 100);
  void close();
  bool isOpen() const { return static_cast<bool>(database_); }
  std::string message() const { return database_.message(); }
  // The file itself, not a row, cannot be read.
  bool damaged() const;
  // Another process has it locked.
  bool busy() const;
  Database& database() { return database_; }

  // A transaction; false rolls all of it back.
  bool begin();
  bool commit();
  void rollback();
  // Drops the rows unused for longest until the file's contents fit `bytes`. The number of rows, or -1.
  int64_t shrink(uint64_t bytes);

  // Shaders: a row a key and generator, so that versions live side by side.
  // Of this generator. Error: ask damaged().
  Found find(KeyKind kind, KeyBytes key, std::vector<uint32_t>& spirv);
  // Whether the file seems to hold shaders of this generator.
  bool holdsCurrent();
  bool put(const ShaderRow& row);
  // One more process used the shader; of this generator.
  bool touch(int64_t id, int64_t now);
  bool removeShader(int64_t number);

  // `number` is the row's, `id` what it says is its shader's. `why` is empty for a good row; else it says
  // what is wrong, and `row` holds what could be read. False: the file could not be read to its end.
  using VisitShader = std::function<void(int64_t number, int64_t id, ShaderRow& row, const std::string& why)>;
  bool visitShaders(const VisitShader& visit);

  // Pipelines, and who needed them.
  bool put(const PipelineRow& row);
  bool touchPipeline(int64_t id, int64_t now);
  bool removePipeline(int64_t id);
  using VisitPipeline = std::function<void(int64_t id, PipelineRow& row, const std::string& why)>;
  bool visitPipelines(const VisitPipeline& visit);

  // The number of a new run, or 0: an error.
  int64_t beginRun(const Program& program, int64_t now);
  // The program's run needed the pipeline. Given a row of another file, the greater numbers are kept.
  bool use(int64_t program, int64_t pipeline, int64_t run, int64_t place);
  bool put(const UsageRow& row);
  bool visitUsage(const std::function<void(const UsageRow&)>& visit);
  // What the program needed in one of its last runs, most used first, then in the order of first use.
  std::vector<PipelineRow> usual(int64_t program, int64_t most);

 private:
  Opened prepareSchema(Mode mode);
  Statement& lazily(Statement& statement, const char* sql);
  bool dropUsageOfNone();

  Database database_;
  Statement find_, put_, touch_, putPipeline_, touchPipeline_, use_, putUsage_, putProgram_;
};

}  // namespace anteroom::cache
