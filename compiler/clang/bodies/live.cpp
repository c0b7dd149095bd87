// Header: compiler/clang/bodies/live.hpp. Test: tests/compiler/clang/shapes_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/bodies/live.hpp"

#include <clang/AST/ASTContext.h>
#include <clang/AST/StmtCXX.h>
#include <clang/Analysis/CFG.h>

#include <memory>
#include <vector>

namespace director::scanning {

namespace {

using namespace clang;

/// Whether what decides where the block leads is no constant.
bool is_open(const CFGBlock& block, const ASTContext& context) {
  const auto* condition = llvm::dyn_cast_or_null<Expr>(block.getTerminatorCondition());
  Expr::EvalResult result;
  return condition != nullptr && !condition->isValueDependent() && !condition->EvaluateAsRValue(result, context);
}

/// `all`: also by edges that Clang leaves out though no constant decides: out of a `switch` over all values of an enum,
/// whose type may have others, and by comparisons that exclude each other, of what may change in between.
std::vector<bool> reached_blocks(const CFG& graph, const ASTContext& context, bool all) {
  std::vector<bool> out(graph.getNumBlockIDs(), false);
  std::vector<const CFGBlock*> waiting{&graph.getEntry()};
  // An exception may come from anywhere in a `try`, so its handlers count.
  for (const CFGBlock* block : graph.try_blocks()) waiting.push_back(block);
  while (!waiting.empty()) {
    const CFGBlock* block = waiting.back();
    waiting.pop_back();
    if (out[block->getBlockID()]) continue;
    out[block->getBlockID()] = true;
    for (const CFGBlock::AdjacentBlock& next : block->succs()) {
      if (const CFGBlock* reached = next.getReachableBlock()) waiting.push_back(reached);
      const CFGBlock* left_out = next.getPossiblyUnreachableBlock();
      if (all && left_out != nullptr && is_open(*block, context)) waiting.push_back(left_out);
    }
  }
  return out;
}

/// Whether a block with an edge to the end reaches it by itself: not by `return`, `throw`, or a call that never
/// returns.
bool falls_through(const CFGBlock& block) {
  if (block.hasNoReturnElement()) return false;
  for (auto element = block.rbegin(); element != block.rend(); ++element) {
    const auto statement = element->getAs<CFGStmt>();
    if (!statement) continue;
    const Stmt* last = statement->getStmt();
    return !llvm::isa<ReturnStmt>(last) && !llvm::isa<CoreturnStmt>(last) && !llvm::isa<CXXThrowExpr>(last) &&
           !llvm::isa<CXXTryStmt>(last);
  }
  return !llvm::isa_and_nonnull<CXXTryStmt>(block.getTerminatorStmt());
}

} // namespace

Live::Live(const FunctionDecl& function) {
  CFG::BuildOptions options;
  options.setAllAlwaysAdd();
  options.AddImplicitDtors = options.AddTemporaryDtors = true; // one of them may end the program
  // Of a coroutine only what the user wrote: the graph would have the rest of it, such as its promise, behind its end.
  Stmt* body = function.getBody();
  const auto* coroutine = llvm::dyn_cast<CoroutineBodyStmt>(body);
  if (coroutine != nullptr) body = coroutine->getBody();
  const std::unique_ptr<CFG> graph = CFG::buildCFG(&function, body, &function.getASTContext(), options);
  if (graph == nullptr) return; // unknown
  const std::vector<bool> live = reached_blocks(*graph, function.getASTContext(), true);
  for (const CFGBlock* block : *graph) {
    if (live[block->getBlockID()]) continue;
    for (const CFGElement& element : *block) {
      if (const auto statement = element.getAs<CFGStmt>()) dead_.insert(statement->getStmt());
    }
  }
  if (coroutine != nullptr) return; // its caller has its answer since it was called
  const std::vector<bool> reached = reached_blocks(*graph, function.getASTContext(), false); // as -Wreturn-type
  for (const CFGBlock* block : graph->getExit().preds()) {
    if (block != nullptr && reached[block->getBlockID()] && falls_through(*block)) reaches_end_ = true;
  }
}

} // namespace director::scanning
