// SPDX-License-Identifier: MIT
// Different ways to write a body that does what the behaviour declares: none is reported, and each is reported if it
// does something else. Also what blocks, in different shapes, and what only looks as if it did.
#include "tests/compiler/clang/workshop.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace {

using namespace director::tests;

struct Shape {
  const char* name;
  const char* helpers; ///< outside of the class; there `S` is the state, `Run` the context
  const char* body;
};

const Shape promises[] = {
    {"Guard", "struct OnExit { Run& run; ~OnExit() { run.set(S::on); } };", "OnExit exit{run}; return ask(run);"},
    {"Temporary", "struct Last { Run& run; explicit Last(Run& r) : run(r) {} ~Last() { run.set(S::on); } };",
     "Last{run}; return ask(run);"},
    {"Held", "struct End { Run& run; ~End() { run.set(S::on); } }; struct Has { End end; };",
     "const Has has{{run}}; return ask(run);"},
    {"Lambda", "", "const auto set = [&run] { run.set(S::on); }; set(); return ask(run);"},
    {"GenericLambda", "",
     "const auto set = [](auto& r, auto v) { r.try_set(v); return ask(r); }; return set(run, S::on);"},
    {"Template", "template <class R, S value> Outcome finish(R& run) { run.set(value); return ask(run); }",
     "return finish<Run, S::on>(run);"},
    {"Function", "", "std::function<void(S)> f = [&](S v) { run.try_set(v); }; f(S::on); return ask(run);"},
    {"OtherFile", "Outcome elsewhere(Run& run);", "return elsewhere(run);"},
    {"Macro", "#define FINISH(run, v) do { (run).set(v); return ask(run); } while (false)\n", "FINISH(run, S::on);"},
    {"Reference", "", "auto& r = run; auto&& s = r; s.set(S::on); return ask(std::ref(r).get());"},
    {"Pointer", "", "auto* p = &run; p->set(S::on); auto pp = &p; return ask(**pp);"},
    {"EarlyReturn", "",
     "if (mode_ > 3) return run.keep(); if (mode_ > 2) { run.set(S::on); return run.done(); } return ask(run);"},
    {"Exception", "",
     "try { if (mode_) throw std::runtime_error(\"x\"); return ask(run); } "
     "catch (const std::exception&) { run.set(S::on); return run.fail(); }"},
    {"Alias", "namespace d = deep; using T = S; using X = d::Leg;", "run.set(T::on); return run.request(X{});"},
    {"ConstexprIf",
     "template <bool B> Outcome act(Run& run) { if constexpr (B) { run.set(S::on); return ask(run); } "
     "else { return run.keep(); } }",
     "return act<true>(run);"},
    {"OfC", "extern \"C\" { typedef void (*Back)(void*); } inline void call(Back f, void* p) { f(p); }",
     "call([](void* p) { static_cast<Run*>(p)->set(S::on); }, &run); return ask(run);"},
    {"Visit",
     "template <class... F> struct Over : F... { using F::operator()...; }; template <class... F> Over(F...) -> "
     "Over<F...>;",
     "std::variant<int, char> v{mode_}; return std::visit(Over{[&](int) { run.set(S::on); return run.keep(); }, "
     "[&](char) { return ask(run); }}, v);"},
    {"Algorithm", "",
     "const int a[] = {1, 2}; std::for_each(a, a + 2, [&](int) { run.set(S::on); }); return ask(run);"},
    {"Loop",
     "struct Range { Run& run; int* begin() const { run.set(S::on); return nullptr; } int* end() const { return "
     "nullptr; } };",
     "for (const int each : Range{run}) mode_ += each; return ask(run);"},
    {"Choice", "", "run.try_set(mode_ ? S::on : S::none); return mode_ ? run.keep() : ask(run);"},
    {"Switch", "",
     "switch (mode_) { case 1: run.set(S::on); [[fallthrough]]; case 2: return ask(run); default: return run.keep(); "
     "}"},
    {"AfterAllCases", "enum class M : unsigned char { a, b };",
     "switch (static_cast<M>(mode_)) { case M::a: return run.keep(); case M::b: return run.done(); } run.set(S::on); "
     "return ask(run);"},
    {"VolatileTwice", "",
     "volatile int pin = mode_; if (pin == 1 && pin == 2) { run.set(S::on); return ask(run); } return run.keep();"},
    {"Argument", "inline Outcome act(Run& run, Outcome out) { run.set(S::on); return out; }",
     "return act(run, ask(run));"},
    {"AtOnce", "", "return [&]() -> Outcome { if (mode_) { run.set(S::on); return run.done(); } return ask(run); }();"},
    {"Recursion",
     "inline Outcome act(Run& run, int n) { if (n == 0) { run.set(S::on); return ask(run); } return act(run, n - 1); }",
     "return act(run, 3);"},
    {"Chain",
     "struct Helper { Run& run; Helper& on() { run.set(S::on); return *this; } Outcome end() const { return ask(run); "
     "} };",
     "return Helper{run}.on().end();"},
    {"Concept",
     "template <class R> concept Runs = requires(R& r) { r.keep(); }; "
     "inline Outcome act(Runs auto& run) { run.set(S::on); return ask(run); }",
     "return act(run);"},
    {"Optional", "",
     "std::optional<Outcome> out; if (mode_) out = ask(run); if (!out) { run.set(S::on); out = run.keep(); } return "
     "*out;"},
    {"Invoke", "", "return std::invoke([&](int) { run.set(S::on); return ask(run); }, 3);"},
    {"Curious",
     "template <class D> struct Base { Outcome go(Run& run) { return static_cast<D*>(this)->act(run); } }; "
     "struct Mine : Base<Mine> { Outcome act(Run& run) { run.set(S::on); return ask(run); } };",
     "return Mine{}.go(run);"},
    {"Operator", "struct Out { Run& run; Out& operator<<(int) { run.set(S::on); return *this; } };",
     "Out out{run}; out << 3; return ask(run);"},
    {"TwoLambdas", "",
     "const auto one = [&] { return run.keep(); }; const auto two = [&] { run.set(S::on); return ask(run); }; "
     "return mode_ ? one() : two();"},
    {"LambdaArguments", "template <class F> Outcome go(Run& run, F f) { return f(run); }",
     "return mode_ ? go(run, [](Run& r) { return r.keep(); }) "
     ": go(run, [](Run& r) { r.set(S::on); return ask(r); });"},
    {"LocalClasses", "",
     "if (mode_) { struct Way { Outcome go(Run& r) { return r.keep(); } }; return Way{}.go(run); } "
     "struct Way { Outcome go(Run& r) { r.set(S::on); return ask(r); } }; return Way{}.go(run);"},
    {"ObjectArguments",
     "struct N { int a; }; template <N n> Outcome go(Run& run) { if constexpr (n.a == 2) { run.set(S::on); "
     "return ask(run); } else { return run.keep(); } }",
     "return mode_ ? go<N{1}>(run) : go<N{2}>(run);"},
    {"Aggregate",
     "inline int put(Run& run) { run.set(S::on); return 1; } struct Plan { Run& run; int done = put(run); };",
     "mode_ = Plan{run}.done; return ask(run);"},
    {"Rewritten", "struct Eq { Run& run; bool operator==(const Eq&) const { run.set(S::on); return true; } };",
     "if (Eq{run} != Eq{run}) return run.keep(); return ask(run);"},
    {"Deleted",
     "struct Way { virtual ~Way() = default; }; struct Bold final : Way { Run& run; explicit Bold(Run& r) : run(r) {} "
     "~Bold() override { run.set(S::on); } };",
     "Way* way = new Bold(run); delete way; return ask(run);"},
    {"Braces", "", "constexpr int which = static_cast<int>(S::on); run.try_set(S{which}); return ask(run);"},
    {"EndsTheProgram", "struct Fatal { int i; [[noreturn]] ~Fatal() { std::abort(); } };",
     "if (mode_) { run.set(S::on); return ask(run); } Fatal{3};"},
    {"EndsInLocal", "struct Fatal { int i; [[noreturn]] ~Fatal() { std::abort(); } };",
     "if (mode_) { run.set(S::on); return ask(run); } const Fatal last{3}; mode_ = last.i;"},
    {"PartlyTemporary",
     "struct Last { Run& run; ~Last() { run.set(S::on); } bool good() const { return true; } "
     "Outcome act() const { return ask(run); } };",
     "const Last local{run}; return mode_ ? Last{run}.act() : mode_ > 3 && Last{run}.good() ? local.act() : "
     "run.keep();"},
    {"FinalOverrider",
     "struct Way { virtual ~Way() = default; virtual Outcome act(Run& run) { return run.keep(); } }; "
     "struct Bold final : Way { Outcome act(Run& run) override { run.set(S::on); return ask(run); } };",
     "Bold bold; return static_cast<Way&>(bold).act(run);"},
    {"AppliedTuple", "",
     "return std::apply([](Run& r, int) { r.set(S::on); return ask(r); }, std::tuple<Run&, int>{run, mode_});"},
    {"ChosenVariant", "",
     "std::variant<int, Run*> way{&run}; if (!std::holds_alternative<Run*>(way)) return run.keep(); "
     "Run* const* const r = std::get_if<Run*>(&way); (*r)->set(S::on); return ask(**r);"},
    {"HeldDeleter", "struct Last { void operator()(Run* run) const { run->set(S::on); } };",
     "const std::unique_ptr<Run, Last> last(&run); return ask(run);"},
    {"ReferredDeleter", "struct Last { void operator()(Run* run) const { run->set(S::on); } };",
     "Last end; const std::unique_ptr<Run, Last&> last(&run, end); return ask(run);"},
    {"InheritedDeleter",
     "struct Deletes { void operator()(Run* run) const { run->set(S::on); } }; struct Last : Deletes {};",
     "const std::unique_ptr<Run, Last> last(&run); return ask(run);"},
    {"OneOfManyDeleters", "template <class T> struct Last { void operator()(T* run) const { run->set(S::on); } };",
     "const std::unique_ptr<Run, Last<Run>> last(&run); return ask(run);"},
    {"InheritedOneOfMany",
     "template <class T> struct Deletes { void operator()(T* run) const { run->set(S::on); } }; "
     "struct Last : Deletes<Run> {};",
     "const std::unique_ptr<Run, Last> last(&run); return ask(run);"},
    {"HeldDerived",
     "struct Way { virtual ~Way() = default; }; struct Last : Way { Run& run; explicit Last(Run& r) : run(r) {} "
     "~Last() override { run.set(S::on); } };",
     "const std::unique_ptr<Way> last(new Last(run)); return ask(run);"},
    {"HeldGuard", "struct Last { Run& run; explicit Last(Run& r) : run(r) {} ~Last() { run.set(S::on); } };",
     "const std::unique_ptr<Last> last(new Last(run)); return ask(run);"},
    {"HeldTree",
     "struct Last { std::vector<Last> below; std::unique_ptr<Last> next; Run* run = nullptr; "
     "~Last() { if (run != nullptr) run->set(S::on); } };",
     "Last last; last.run = &run; return ask(run);"},
    {"HeldPair", "struct Last { Run* run = nullptr; ~Last() { if (run != nullptr) run->set(S::on); } };",
     "std::pair<Last, int> last; last.first.run = &run; return ask(run);"},
    {"StoredAndSeen",
     "inline Run* now; inline Outcome finish() { now->set(S::on); return ask(*now); } int unrelated();",
     "now = &run; Run* const here = &run; now = here; return finish();"},
    {"StoredHere", "struct Plan { Run* run; }; int unrelated();",
     "Plan plan{}; plan.run = &run; plan.run->set(S::on); if (unrelated()) return run.keep(); return ask(run);"},
    {"OfBase",
     "struct Way { int steps = 0; int next() { return ++steps; } }; struct Bold : Way { Run& run; explicit Bold(Run& "
     "r) : "
     "run(r) {} Outcome act() { steps += next(); run.set(S::on); return ask(run); } }; int unrelated();",
     "Bold bold(run); bold.steps = unrelated(); return bold.act();"},
    {"CoroutineEnd",
     "struct Last { struct promise_type { Run& run; explicit promise_type(Run& r) : run(r) {} "
     "~promise_type() { run.set(S::on); } Last get_return_object() { return {}; } "
     "std::suspend_never initial_suspend() { return {}; } std::suspend_never final_suspend() noexcept { return {}; } "
     "void return_void() {} void unhandled_exception() {} }; }; inline Last go(Run&) { co_return; }",
     "go(run); return ask(run);"},
    {"Coroutine", "inline Steps go(Run& run) { run.set(S::on); co_return; }", "go(run).next(); return ask(run);"},
    {"CoroutineYields", "inline Steps go(Run& run) { co_yield 3; run.set(S::on); }",
     "go(run).next(); return ask(run);"},
    {"CoroutineWaits",
     "struct Waits { Run& run; bool await_ready() { run.set(S::on); return true; } void await_suspend(auto) {} "
     "void await_resume() {} }; inline Steps go(Run& run) { co_await Waits{run}; }",
     "go(run).next(); return ask(run);"},
    {"CoroutineAnswers",
     "struct Last { struct promise_type { Run& run; explicit promise_type(Run& r) : run(r) {} Last get_return_object() "
     "{ "
     "return {}; } std::suspend_never initial_suspend() { return {}; } std::suspend_never final_suspend() noexcept { "
     "return {}; } void return_value(int) { run.set(S::on); } void unhandled_exception() {} }; }; "
     "inline Last go(Run&) { co_return 3; }",
     "go(run); return ask(run);"},
    {"CoroutineLambda", "",
     "const auto go = [](Run& r) -> Steps { r.set(S::on); co_return; }; go(run).next(); return ask(run);"},
    {"CastNumber", "", "run.try_set(S(static_cast<int>(S::on))); return ask(run);"},
    {"Cleanup", "inline void finish(Run** run) { (*run)->set(S::on); }",
     "__attribute__((cleanup(finish))) Run* last = &run; return ask(*last);"},
    {"HeldPlan", "struct Plan { Run& run; Outcome act() const { run.set(S::on); return ask(run); } };",
     "const std::optional<Plan> plan(Plan{run}); const std::pair<Plan, int> two(plan.value(), 1); "
     "return two.first.act();"},
    {"HeldPointers", "",
     "const std::vector<Run*> all{&run}; const std::tuple<int, Run&> two(mode_, *all.front()); "
     "std::get<1>(two).set(S::on); return ask(run);"},
    {"HeldElsewhere", "struct Way { explicit Way(int) {} void go() {} };",
     "std::optional<Way> way(mode_); way.emplace(3); const std::vector<Way> all(3, Way(mode_)); way->go(); "
     "run.set(S::on); return ask(run);"},
};

const Shape out_of_sight[] = {
    {"Virtual",
     "struct Way { virtual ~Way() = default; virtual Outcome act(Run& run) = 0; }; "
     "struct Bold : Way { Outcome act(Run& run) override { run.set(S::on); return ask(run); } }; inline Bold bold;",
     "Way* way = &bold; return way->act(run);"},
    {"VirtualOperator",
     "struct Way { virtual ~Way() = default; virtual Outcome operator()(Run& run) const { return run.keep(); } }; "
     "struct Bold : Way { Outcome operator()(Run& run) const override { run.set(S::on); return ask(run); } }; "
     "inline Bold bold; inline const Way& way() { return bold; }",
     "return way()(run);"},
    {"VirtualAssignment",
     "struct Way { virtual ~Way() = default; virtual void operator-=(Run&) {} }; "
     "struct Bold : Way { void operator-=(Run& run) override { run.set(S::on); } }; "
     "inline Bold bold; inline Way& way() { return bold; }",
     "way() -= run; return ask(run);"},
    {"OpaqueData", "extern \"C\" int plan(void* user);", "return plan(&run) ? run.keep() : ask(run);"},
    {"OpaqueBase", "struct Held { Run* run; }; struct Plan : Held { int i; }; Outcome act(Plan& plan);",
     "Plan plan{{&run}, 1}; return act(plan);"},
    {"OpaqueArray", "struct Plan { Run* runs[2]; }; Outcome act(Plan& plan);",
     "Plan plan{{&run, &run}}; return act(plan);"},
    {"OpaqueVariant", "Outcome act(std::variant<std::monostate, Run*> what);", "return act(&run);"},
    {"OpaqueDepth",
     "struct A { Run& run; }; struct B { A a; }; struct C { B b; }; struct D { C c; }; struct E { D d; }; "
     "Outcome act(E& e);",
     "E e{{{{{run}}}}}; return act(e);"},
    {"OpaquePointer", "extern \"C\" int plan(void* user);",
     "void* user = &run; return plan(user) ? run.keep() : ask(run);"},
    {"OpaqueNumber", "int plan(unsigned long user);",
     "const auto user = reinterpret_cast<unsigned long>(&run); return plan(user) ? run.keep() : ask(run);"},
    {"OpaqueReference",
     "struct Way { virtual ~Way() = default; }; struct Bold final : Way { Run& run; explicit Bold(Run& r) : run(r) {} "
     "}; "
     "Outcome act(Way& way);",
     "Bold bold(run); Way& way = bold; return act(way);"},
    {"OpaqueCast", "struct Plan { int i; }; inline Plan* kept; int plan();",
     "Plan& user = reinterpret_cast<Plan&>(run); kept = &user; return plan() ? run.keep() : ask(run);"},
    {"OpaqueMemory", "struct Held { Run& run; }; alignas(Held) inline unsigned char raw[sizeof(Held)]; int plan();",
     "new (raw) Held{run}; return plan() ? run.keep() : ask(run);"},
    {"TemplateDeleter", "struct Last { template <class T> void operator()(T* run) const { run->set(S::on); } };",
     "const std::unique_ptr<Run, Last> last(&run); return ask(run);"},
    {"OpaqueAny", "Outcome act(std::any what);", "return act(std::any(&run));"},
    {"StoredAndCalled",
     "inline Run* now; inline std::function<Outcome()> policy = [] { now->set(S::on); return ask(*now); };",
     "now = &run; return policy();"},
    {"StoredAndPointed", "inline Run* now; inline Outcome (*way)() = [] { now->set(S::on); return ask(*now); };",
     "now = &run; return way();"},
    {"StoredElsewhere", "struct Held { Run* run; }; inline Held held; Outcome act();",
     "held = Held{&run}; return act();"},
    {"Pointers", "",
     "Outcome (*const ways[])(Run&) = {[](Run& r) { return r.keep(); }, [](Run& r) { r.set(S::on); return ask(r); }}; "
     "return ways[mode_ & 1](run);"},
    {"Bind", "inline Outcome act(int, Run& run) { run.set(S::on); return ask(run); }",
     "return std::bind_front(&act, mode_)(run);"},
    {"LibraryLocks", "struct Busy { Run& run; void lock() {} void unlock() { run.set(S::on); } };",
     "Busy busy{run}; const std::lock_guard guard(busy); return ask(run);"},
    {"LibraryLocksLater", "struct Busy { Run& run; void lock() { run.set(S::on); } void unlock() {} };",
     "Busy busy{run}; std::unique_lock guard(busy, std::defer_lock); guard.lock(); return ask(run);"},
    {"LibraryMakes", "struct Step { explicit Step(Run& run) { run.set(S::on); } };",
     "const std::optional<Step> step(std::in_place, run); return ask(run);"},
    {"LibraryConverts", "struct Step { Step(Run& run) { run.set(S::on); } };",
     "const std::pair<Step, int> step(run, 1); return ask(run);"},
    {"LibraryMakesPart",
     "struct Step { explicit Step(Run& run) { run.set(S::on); } }; struct Stair : Step { using Step::Step; };",
     "const std::variant<int, Stair> stair(std::in_place_type<Stair>, run); return ask(run);"},
    {"LibraryCopies",
     "struct Step { Run& run; explicit Step(Run& r) : run(r) {} Step(const Step& o) : run(o.run) { run.set(S::on); } "
     "};",
     "const Step step(run); const std::optional<Step> other(step); return ask(run);"},
    {"LibraryDeletes", "struct Last { Run* run; void operator()(int*) const { run->set(S::on); } };",
     "const std::shared_ptr<int> last(nullptr, Last{&run}); return ask(run);"},
    {"LibraryCalls", "struct Last { Run* run; void operator()() const { run->set(S::on); } };",
     "std::thread(Last{&run}).join(); return ask(run);"},
    {"LibraryPointers", "inline Outcome act(Run& run) { return run.keep(); } inline Outcome (*way)(Run&) = &act;",
     "std::thread(way, std::ref(run)).join(); return ask(run);"},
    {"StoredAndMade", "inline Run* now; struct Step { Step() { now->set(S::on); } };",
     "now = &run; const std::vector<Step> steps(3); return ask(run);"},
    {"StoredAndMadeOne", "inline Run* now; struct Step { Step() { now->set(S::on); } };",
     "now = &run; std::make_unique<Step>(); return ask(run);"},
};

struct Program {
  std::string yaml, source, elsewhere;
};

/// What the coroutines return.
const char* const steps = R"(struct Steps {
  struct promise_type {
    Steps get_return_object() { return {std::coroutine_handle<promise_type>::from_promise(*this)}; }
    std::suspend_always initial_suspend() { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_never yield_value(int) { return {}; }
    void return_void() {}
    void unhandled_exception() {}
  };
  std::coroutine_handle<promise_type> handle;
  void next() { handle.resume(); }
};
)";

std::string title(const Shape& shape) {
  return fmt::format("namespace of_{0} {{\nusing S = deep::S{0};\nusing Run = deep::{0}::Default;\n{1}\n}}\n",
                     shape.name, shape.helpers);
}

Program program() {
  Program out;
  std::string states, groups, bodies;
  const auto add = [&](const Shape& shape) {
    states += fmt::format("  S{}: {{values: [none, on, off]}}\n", shape.name);
    groups += fmt::format("  {0}: {{module: robot, causing: [S{0} == on], sets: [S{0} == none|off], tasks: [Leg]}}\n",
                          shape.name);
    out.source += title(shape);
    bodies += fmt::format("Outcome provide(deep::{0}::Default& run) override {{ using namespace of_{0}; {1} }}\n",
                          shape.name, shape.body);
  };
  for (const Shape& shape : promises) add(shape);
  for (const Shape& shape : out_of_sight) add(shape);
  out.yaml =
      "behaviour: deep\nlanguage: 1\nstates:\n" + states + "roots: [Leg]\ngroups:\n  Leg: {module: legs}\n" + groups;
  const std::string head =
      "#include \"deep.hpp\"\n#include <algorithm>\n#include <any>\n#include <coroutine>\n"
      "#include <cstdlib>\n#include <functional>\n#include <memory>\n#include <mutex>\n#include <optional>\n"
      "#include <stdexcept>\n#include <thread>\n#include <tuple>\n#include <utility>\n#include <variant>\n#include "
      "<vector>\nusing director::Outcome;\n" +
      std::string(steps) + "template <class R> Outcome ask(R& run) { return run.request(deep::Leg{}); }\n";
  out.elsewhere = head + "namespace of_OtherFile { Outcome elsewhere(deep::OtherFile::Default& run) { "
                         "run.set(deep::SOtherFile::on); return ask(run); } }\n";
  out.source = head + out.source + "class MyRobot final : public deep::Robot {\nint mode_ = 0;\n" + bodies +
               "};\nclass MyLegs final : public deep::Legs { Outcome provide(deep::Leg::Default& run) override { "
               "return run.done(); } };\n";
  return out;
}

Worked verified(const Workshop& work, const Program& program) {
  work.write("deep.yaml", program.yaml);
  work.write("body.cpp", program.source);
  work.write("far.cpp", program.elsewhere);
  const Worked generated = work.directorc({"generate", work.path("deep.yaml"), "-o", work.path("generated")});
  INFO(generated.err);
  REQUIRE(generated.status == 0);
  work.write_commands({work.path("body.cpp"), work.path("far.cpp")},
                      {"-std=c++20", "-I" + work.path("generated"), "-I" + source_folder()});
  return work.directorc({"verify", work.path("deep.yaml"), "-p", work.path(), "--generated", work.path("generated")});
}

/// The output without places.
std::vector<std::string> lines_with(const std::string& text, const std::string& word) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t at = line.find(word);
    if (at != std::string::npos) out.push_back(line.substr(at));
  }
  return out;
}

TEST_CASE("in whatever shape a body keeps its promise, that is recognised, or reported as undecided") {
  const Worked worked = verified(Workshop("shapes"), program());
  CHECK(worked.out == "");
  INFO(worked.err);
  for (const Shape& shape : out_of_sight) {
    CAPTURE(shape.name);
    CHECK(!lines_with(worked.err, fmt::format("not decided: `{}`: it is not known", shape.name)).empty());
  }
  for (const Shape& shape : promises) {
    CAPTURE(shape.name);
    CHECK(lines_with(worked.err, fmt::format("not decided: `{}`", shape.name)).empty());
  }
}

TEST_CASE("in whatever shape a body breaks its promise, it is reported once") {
  Program broken = program();
  for (std::string* text : {&broken.source, &broken.elsewhere})
    *text = std::regex_replace(*text, std::regex("(S|T|SOtherFile)::on"), "$1::off");
  const Worked worked = verified(Workshop("broken-shapes"), broken);
  std::vector<std::string> expected;
  const std::set<std::string> computed{"GenericLambda", "Function"}; // their parameters may have any value
  for (const Shape& shape : promises)
    if (computed.count(shape.name) == 0)
      expected.push_back(
          fmt::format("no path of `{0}` sets what it promises, `S{0} == on` [causing_never_set]", shape.name));
  CHECK(lines_with(worked.out + worked.err, "no path of") == expected);
}

const Shape never[] = {
    {"DeadIf", "", "if (false) run.set(S::on); return ask(run);"},
    {"DeadConstant", "constexpr struct { bool on; } debug{false};", "if (debug.on) run.set(S::on); return ask(run);"},
    {"DeadWhile", "", "while (false) run.set(S::on); return ask(run);"},
    {"DeadFor", "", "for (int i = 0; false; ++i) run.set(S::on); return ask(run);"},
    {"DeadCase", "", "switch (sizeof(char)) { case 2: run.set(S::on); break; default: break; } return ask(run);"},
    {"DeadChoice", "inline int put(Run& run) { run.set(S::on); return 1; }",
     "mode_ = sizeof(char) == 2 ? put(run) : 3; return ask(run);"},
    {"DeadAnd", "inline bool put(Run& run) { run.set(S::on); return true; }",
     "if (false && put(run)) return run.keep(); return ask(run);"},
    {"DeadValue", "", "run.try_set(sizeof(char) == 2 ? S::on : S::off); return ask(run);"},
    {"HeldWeakly", "struct Last { Run& run; ~Last() { run.set(S::on); } };",
     "const std::weak_ptr<Last> last; return ask(run);"},
    {"DeadRequires", "", "if constexpr (requires { run.set(S::on); }) return ask(run); return run.keep();"},
    {"BehindReturn", "", "return ask(run); run.set(S::on);"},
    {"BehindLoop", "", "for (;;) { if (mode_ > 3) return ask(run); } run.set(S::on);"},
    {"BehindTemporary", "struct Fatal { int i; [[noreturn]] ~Fatal() { std::abort(); } };",
     "if (mode_ > 3) { Fatal{3}; run.set(S::on); } return ask(run);"},
    {"BehindEnd", "", "if (mode_ > 3) { std::abort(); run.set(S::on); } return ask(run);"},
};

TEST_CASE("what the text of a body rules out is not counted") {
  Program program;
  std::string states, groups, bodies;
  std::vector<std::string> expected;
  for (const Shape& shape : never) {
    states += fmt::format("  S{}: {{values: [none, on, off]}}\n", shape.name);
    groups += fmt::format("  {0}: {{module: robot, causing: [S{0} == on], sets: [S{0} == none|off], tasks: [Leg]}}\n",
                          shape.name);
    program.source += title(shape);
    bodies += fmt::format("Outcome provide(deep::{0}::Default& run) override {{ using namespace of_{0}; {1} }}\n",
                          shape.name, shape.body);
    expected.push_back(
        fmt::format("no path of `{0}` sets what it promises, `S{0} == on` [causing_never_set]", shape.name));
  }
  program.yaml =
      "behaviour: deep\nlanguage: 1\nstates:\n" + states + "roots: [Leg]\ngroups:\n  Leg: {module: legs}\n" + groups;
  program.source = "#include \"deep.hpp\"\n#include <cstdlib>\n#include <memory>\nusing director::Outcome;\n"
                   "template <class R> Outcome ask(R& run) { return run.request(deep::Leg{}); }\n" +
                   program.source + "class MyRobot final : public deep::Robot {\nint mode_ = 0;\n" + bodies +
                   "};\nclass MyLegs final : public deep::Legs { Outcome provide(deep::Leg::Default& run) override { "
                   "return run.done(); } };\n";
  const Worked worked = verified(Workshop("never-shapes"), program);
  INFO(worked.err);
  CHECK(lines_with(worked.out + worked.err, "no path of") == expected);
}

struct Home {
  const char* name;
  const char* source; ///< BODY stands for the body
  bool is_seen;
};

const Home homes[] = {
    {"Factory",
     "deep::Robot& make() { class Mine final : public deep::Robot { BODY }; static Mine mine; return mine; }", true},
    {"FactoryTemplate",
     "template <class T> deep::Robot& make(T) { struct Mine final : deep::Robot { BODY }; static Mine mine; return "
     "mine; } "
     "deep::Robot& it = make(3);",
     true},
    {"Lambda",
     "auto make = []() -> deep::Robot& { struct Mine : deep::Robot { BODY }; static Mine mine; return mine; };", true},
    {"TemplateBase",
     "template <class I> class With : public I { BODY }; class Mine final : public With<deep::Robot> {};", true},
    {"Template", "template <class I> class With : public I { BODY };", false},
    {"TemplateBelow", "class Any : public deep::Robot {}; template <class T> class Mine : public Any { BODY };", false},
    {"TemplateOfMine", "template <int size> class Mine : public deep::Robot { BODY };", false},
};

TEST_CASE("wherever a class is its bodies are found, or it is reported that they are not") {
  const std::string body = "director::Outcome provide(deep::Walk::Default& run) override { return run.keep(); }";
  for (const Home& home : homes) {
    CAPTURE(home.name);
    Program program;
    program.yaml = "behaviour: deep\nlanguage: 1\nroots: [Walk]\ngroups:\n  Walk: {module: robot, tasks: [Leg]}\n"
                   "  Leg: {module: legs}\n";
    program.source = "#include \"deep.hpp\"\n" +
                     std::regex_replace(std::string(home.source), std::regex("BODY"), body) +
                     "\nclass MyLegs final : public deep::Legs { director::Outcome provide(deep::Leg::Default& run) "
                     "override { return run.done(); } };\n";
    const Worked worked = verified(Workshop("home-shapes"), program);
    INFO(worked.err);
    CHECK(worked.status == 0);
    const std::vector<std::string> found{
        "every path of `Walk` ends in `keep()`: it never requests anything, and is never done [only_keeps]"};
    CHECK(lines_with(worked.out, "every path") == (home.is_seen ? found : std::vector<std::string>{}));
    CHECK(worked.err == (home.is_seen ? "" : "directorc: not decided: no body was found for `Walk`\n"));
  }
}

struct Call {
  const char* name;
  const char* why; ///< empty: it does not block
  const char* body;
};

const Call calls[] = {
    {"TryLock", "", "std::unique_lock l(mutex, std::try_to_lock); if (!l) return run.keep();"},
    {"DeferLock", "", "std::unique_lock l(mutex, std::defer_lock); if (l.try_lock()) ++n;"},
    {"Print", "", "char c[20]; std::snprintf(c, sizeof c, \"%d\", n);"},
    {"Atomic", "", "std::atomic<int> a; a.store(1); a.fetch_add(2);"},
    {"Placement", "", "alignas(int) unsigned char raw[sizeof(int)]; int* p = new (raw) int(3); n = *p;"},
    {"View", "", "std::string_view v(\"abc\"); n = static_cast<int>(v.substr(1).size());"},
    {"Compare", "", "if (text == \"x\") n = static_cast<int>(text.size());"},
    {"Sort", "", "int x[3]{}; std::sort(x, x + 3); n = x[0];"},
    {"MoveMade", "", "std::vector<int> w(std::move(row)); n = w[0];"},
    {"MoveGiven", "", "row = std::move(other);"},
    {"Swap", "", "std::swap(row, other); row.clear(); row.pop_back();"},
    {"Find", "", "if (auto it = map.find(2); it != map.end()) it->second = 1;"},
    {"Emplace", "", "std::optional<int> o; o.emplace(3); o = 4; n = *o;"},
    {"Trait", "", "n = noexcept(row.push_back(1)) ? 1 : 2;"},
    {"SmallFunction", "", "std::function<int()> f = [&] { return n; }; n = f();"},
    {"OwnBase", "", "struct Own : Noisy { using Noisy::Noisy; }; static Own own; n = own.i;"},
    {"InheritedMaker", "uses the heap", "const Heir heir(3); n = heir.i;"},
    {"Shared", "", "std::shared_ptr<int> p(shared), q = p; n = *q;"},
    {"Byte", "", "auto b = std::byte{3} << 4; b = b >> 1; b <<= 2; n = std::to_integer<int>(b);"},
    {"AdoptLock", "", "std::scoped_lock l(std::adopt_lock, mutex); ++n;"},
    {"TryTimed", "", "if (timed.try_lock()) timed.unlock();"},
    {"OwnArena", "",
     "std::pmr::vector<int> v(&arena); v.push_back(1); std::pmr::string s(\"more than there is room for in it\", "
     "&arena); "
     "std::pmr::map<int, int> m(&arena); m[2] = v[0]; n = static_cast<int>(s.size());"},
    {"OwnAllocator", "", "static std::vector<int, Fixed<int>> v; v.push_back(1); v.resize(3);"},
    {"SmallAny", "", "std::any a = 3; a = 4; n = std::any_cast<int>(a);"},
    {"Range", "", "int x[3]{}; std::ranges::sort(x); n = *std::ranges::max_element(x);"},
    {"MoveText", "", "std::string s(std::move(text)); text = std::move(s);"},
    {"MoveOptional", "", "std::optional<std::string> o(std::move(maybe)); maybe = std::move(o);"},
    {"Variant", "", "std::variant<int, char> v{n}; n = std::visit([](auto x) { return static_cast<int>(x); }, v);"},
    {"Notify", "", "condition.notify_all(); std::atomic<int> a; a.notify_one();"},
    {"ConstantIf", "", "if (sizeof(int) == 1) std::puts(\"x\");"},
    {"ConstantWhile", "", "while (debug) std::puts(\"x\"); for (; debug;) std::puts(\"y\");"},
    {"ConstantSwitch", "", "switch (sizeof(int)) { case 1: std::puts(\"x\"); break; default: ++n; }"},
    {"ConstantChoice", "", "n = debug ? std::puts(\"x\") : 3; n = debug && std::puts(\"y\") > 0;"},
    {"Behind", "", "return run.done(); std::puts(\"x\");"},
    {"Computed", "",
     "constexpr int size = [] { const int* p = new int(3); const int r = *p; delete p; return r; }(); n = size;"},
    {"PathCompare", "", "n = here == there ? 1 : 2; std::filesystem::swap(here, there);"},
    {"Flags", "", "n = static_cast<int>(std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);"},
    {"SharedArena", "uses the heap", "std::pmr::vector<int> v; v.push_back(1);"},
    {"HeapAllocator", "uses the heap", "static std::vector<int, Heap<int>> v; v.push_back(1);"},
    {"SpinLock", "sleeps", "static Patient p; std::scoped_lock l(p);"},
    {"TimedLock", "waits", "if (timed.try_lock_for(std::chrono::seconds(1))) timed.unlock();"},
    {"RecursiveTimed", "waits",
     "static std::recursive_timed_mutex m; "
     "if (m.try_lock_until(std::chrono::steady_clock::now())) m.unlock();"},
    {"SharedTimed", "waits",
     "static std::shared_timed_mutex m; if (m.try_lock_shared_for(std::chrono::seconds(1))) m.unlock_shared();"},
    {"UniqueTimed", "waits",
     "std::unique_lock l(timed, std::defer_lock); n = l.try_lock_for(std::chrono::seconds(1)) ? 1 : 0;"},
    {"PosixTimed", "waits",
     "static pthread_mutex_t m = PTHREAD_MUTEX_INITIALIZER; timespec t{}; n = pthread_mutex_timedlock(&m, &t);"},
    {"Descriptor", "does input or output", "dprintf(1, \"%d\", n);"},
    {"Vector", "does input or output", "iovec v{&n, sizeof n}; n = static_cast<int>(writev(1, &v, 1));"},
    {"Rename", "does input or output", "n = std::rename(\"a\", \"b\");"},
    {"Status", "does input or output", "struct stat s; n = stat(\"a\", &s);"},
    {"Reopen", "does input or output", "n = freopen(\"a\", \"r\", stdin) == nullptr;"},
    {"Random", "does input or output", "std::random_device d; n = static_cast<int>(d());"},
    {"RangesStable", "uses the heap", "std::ranges::stable_sort(row);"},
    {"Inserter", "uses the heap", "std::copy(other.begin(), other.end(), std::back_inserter(row));"},
    {"Shrink", "uses the heap", "row.shrink_to_fit();"},
    {"LargeAny", "uses the heap", "std::any a = text; n = static_cast<int>(std::any_cast<std::string>(&a)->size());"},
    {"CopyOptional", "uses the heap", "const auto o = maybe; n = o ? 1 : 2;"},
    {"CopyPair", "uses the heap", "const auto p = pair; n = p.second;"},
    {"CopyTuple", "uses the heap", "const std::tuple<int, std::string> t(n, text); n = std::get<0>(t);"},
    {"Nothrow", "uses the heap", "int* p = new (std::nothrow) int(3); n = p != nullptr;"},
    {"Erase", "uses the heap", "map.erase(3);"},
    {"Replace", "uses the heap", "static std::unique_ptr<int> p, q; p = std::move(q);"},
    {"Visitor", "sleeps", "std::for_each(row.begin(), row.end(), [](int) { ::usleep(3); });"},
    {"HeldObject", "does input or output", "std::optional<Noisy> o; o.emplace(); n = o->i;"},
    {"Joined", "uses the heap, waits", "std::jthread t([] { ++n; });"},
    {"Plus", "uses the heap", "n = static_cast<int>((text + \"x\").size());"},
    {"Copy", "uses the heap", "const auto s = text; n = static_cast<int>(s.size());"},
    {"Assign", "uses the heap", "row = other;"},
    {"Queue", "uses the heap", "static std::queue<int> q; q.push(1);"},
    {"Part", "uses the heap", "n = static_cast<int>(text.substr(1).size());"},
    {"Make", "uses the heap", "n = *std::make_unique<int>(1);"},
    {"SharedNew", "uses the heap", "std::shared_ptr<int> p(raw);"},
    {"LargeFunction", "uses the heap", "int big[20]{}; std::function<int()> f = [big] { return big[0]; }; n = f();"},
    {"StableSort", "uses the heap", "std::stable_sort(row.begin(), row.end());"},
    {"Implicit", "uses the heap", "takes(\"a long text that is no string\");"},
    {"Given", "uses the heap", "takes_default();"},
    {"Member", "uses the heap", "Named x; n = static_cast<int>(x.name.size());"},
    {"Whole", "uses the heap", "Named x{}; x = named;"},
    {"WholeCopy", "uses the heap", "const Named x = named; n = static_cast<int>(x.name.size());"},
    {"Each", "uses the heap", "for (auto x : texts) n += static_cast<int>(x.size());"},
    {"Index", "uses the heap", "map[3] = 1;"},
    {"Sized", "uses the heap", "std::vector<int> z(30); n = z[0];"},
    {"FindInText", "", "static char c[9]; n = std::strchr(c, 'x') != nullptr && std::memchr(c, 'x', 3) != nullptr;"},
    {"Later", "", "job = [] { std::puts(\"x\"); }; jobs[1] = [] { std::puts(\"y\"); };"},
    {"LaterHeld", "", "perhaps.emplace([] { std::puts(\"x\"); }); std::exchange(job, [] { std::puts(\"y\"); });"},
    {"LaterQueued", "uses the heap",
     "static std::deque<std::function<void()>> q; q.push_back([] { std::puts(\"x\"); });"},
    {"LaterBound", "", "job = std::bind([] { std::puts(\"x\"); });"},
    {"LaterThread", "waits", "static std::vector<std::jthread> t; t.emplace_back([] { std::puts(\"x\"); });"},
    {"AtOnce", "does input or output",
     "std::optional<int> o(3); n = std::invoke([&](int i) { return std::puts(\"x\") + i; }, *o);"},
    {"AtOnceSorted", "sleeps", "std::ranges::sort(row, [](int a, int b) { ::usleep(3); return a < b; });"},
    {"AtOnceVisited", "sleeps", "std::variant<int, char> v{n}; std::visit([](auto) { ::usleep(3); }, v);"},
    {"AtOnceOnly", "locks, sleeps", "static std::once_flag f; std::call_once(f, [] { ::usleep(3); });"},
    {"Coroutine", "sleeps, uses the heap", "resting(3).next();"},
    {"Bye", "does input or output", "Noisy x; n = x.i;"},
    {"ByeWithin", "does input or output", "struct Outer { Noisy x; } outer{}; n = outer.x.i;"},
    {"ByeArray", "sleeps", "Slow x[2]{}; n = x[0].i;"},
    {"ByeDeleted", "sleeps, uses the heap", "delete slow;"},
    {"SecondLambda", "does input or output",
     "const auto one = [] { return 1; }; const auto two = [] { return std::puts(\"x\"); }; n = n > 0 ? one() : two();"},
    {"Unequal", "does input or output", "n = Loud{1} != Loud{2} ? 1 : 2;"},
    {"LeftOut", "does input or output", "Lazy x{3}; n = x.j;"},
    {"Stream", "does input or output", "out(std::cout);"},
    {"System", "does input or output", "syslog(LOG_INFO, \"x\");"},
    {"Lock", "locks", "std::scoped_lock l(mutex); ++n;"},
    {"Condition", "waits", "std::unique_lock l(mutex, std::adopt_lock); condition.wait(l);"},
    {"Spin", "waits", "std::atomic<int> a; a.wait(1);"},
};

TEST_CASE("what blocks is reported in whatever shape it comes, and what only looks like it is not") {
  Program program;
  program.yaml = "behaviour: deep\nlanguage: 1\nroots: [G]\ngroups:\n  G: {module: robot}\n";
  program.source = std::string(R"(#include "deep.hpp"
#include <algorithm>
#include <any>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <coroutine>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <deque>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <optional>
#include <pthread.h>
#include <queue>
#include <random>
#include <shared_mutex>
#include <string>
#include <sys/stat.h>
#include <sys/uio.h>
#include <syslog.h>
#include <thread>
#include <tuple>
#include <unistd.h>
#include <variant>
#include <vector>
)") + std::string(steps) +
                   R"(
using director::Outcome;
static Steps resting(int i) { std::this_thread::sleep_for(std::chrono::milliseconds(i)); co_return; }
static std::function<void()> job;
static std::array<std::function<void()>, 2> jobs;
static std::optional<std::function<void()>> perhaps;
static std::mutex mutex;
static std::timed_mutex timed;
static std::condition_variable condition;
constexpr bool debug = false;
static std::optional<std::string> maybe;
static std::pair<std::string, int> pair;
static std::byte memory[4096];
static std::pmr::monotonic_buffer_resource arena(memory, sizeof memory, std::pmr::null_memory_resource());
template <class T> struct Fixed {
  using value_type = T;
  T* allocate(std::size_t) { static T all[100]; return all; }
  void deallocate(T*, std::size_t) {}
  bool operator==(const Fixed&) const { return true; }
};
template <class T> struct Heap {
  using value_type = T;
  T* allocate(std::size_t count) { return static_cast<T*>(std::malloc(count * sizeof(T))); }
  void deallocate(T*, std::size_t) {}
  bool operator==(const Heap&) const { return true; }
};
struct Patient { void lock() { ::usleep(10); } void unlock() {} bool try_lock() { return true; } };
static int n, *raw;
static std::string text;
static std::vector<int> row, other;
static std::vector<std::string> texts;
static std::map<int, int> map;
static std::shared_ptr<int> shared;
struct Noisy { int i = 0; ~Noisy() { std::puts("gone"); } };
struct Slow { int i = 0; ~Slow() { std::this_thread::sleep_for(std::chrono::milliseconds(i)); } };
struct Named { std::string name = "as long as it has to be"; };
static Named named;
struct Maker { int i; explicit Maker(int x) : i(*std::make_unique<int>(x)) {} };
struct Heir : Maker { using Maker::Maker; };
static Slow* slow;
static std::filesystem::path here, there;
struct Loud { int i; bool operator==(const Loud&) const { std::puts("same?"); return true; } };
struct Lazy { int i; int j = std::puts("x"); };
static void takes(const std::string& s) { n = static_cast<int>(s.size()); }
static void takes_default(const std::string& s = "what is not given") { n = static_cast<int>(s.size()); }
static void out(std::ostream& o) { o.put('x'); }
class MyRobot final : public deep::Robot {
  Outcome provide(deep::G::Default& run) override { return run.done(); }
)";
  std::map<std::string, std::string> expected, said;
  for (const Call& each : calls) {
    program.yaml += fmt::format("  {}: {{module: robot, realtime: true}}\n", each.name);
    program.source += fmt::format("  Outcome provide(deep::{}::Default& run) override {{ {} return run.done(); }}\n",
                                  each.name, each.body);
    if (*each.why != '\0') expected[each.name] = each.why;
  }
  program.source += "};\n";
  const Worked worked = verified(Workshop("blocking-shapes"), program);
  INFO(worked.err);
  std::map<std::string, std::set<std::string>> whys;
  const std::regex pattern("warning: `[^`]*` (.*), and `([^`]*)` is `realtime` \\[blocking_call\\]");
  for (const std::string& line : lines_with(worked.out + worked.err, "warning: ")) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) whys[match[2].str()].insert(match[1].str());
  }
  for (const auto& [name, all] : whys) said[name] = fmt::format("{}", fmt::join(all, ", "));
  const auto lines = [](const std::map<std::string, std::string>& all) {
    std::string out;
    for (const auto& [name, why] : all) out += name + ": " + why + "\n";
    return out;
  };
  CHECK(lines(said) == lines(expected));
  CHECK(lines_with(worked.err, "not decided").empty());
}

} // namespace
