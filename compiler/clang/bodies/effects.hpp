#pragma once
// SPDX-License-Identifier: MIT
// Records what a function does that matters to a behaviour: what it says to contexts, what it calls, what may block,
// and what cannot be seen. Where these are in the function's code, and whether they run, is up to the caller.

#include "compiler/clang/bodies/book.hpp"
#include "compiler/clang/bodies/values.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::scanning {

/// What a constructor is given.
struct Given {
  std::vector<clang::QualType> types; ///< as in callbacks.hpp
  bool carries = false;               ///< a context
  bool outside = false;               ///< ... in another way than in a lambda
  bool any = false;                   ///< something that a container may have to hold
};

class Effects {
public:
  explicit Effects(Book& book) : book_(book), values_(book.context()) {}

  /// A use of a context. True: it is one, and nothing else.
  bool add_word(const clang::CallExpr& expr, const clang::CXXMethodDecl& method, const clang::Expr& object);
  /// A call of the user's function, which is queued. `maybe`: its receiver may call it.
  void call(const clang::FunctionDecl& callee, clang::SourceLocation begin, clang::SourceLocation end, bool carries,
            bool maybe, bool is_virtual);
  void call_library(const clang::CallExpr& expr, const clang::FunctionDecl& callee, clang::SourceLocation at);
  void make_of_library(const clang::CXXConstructorDecl& callee, clang::SourceLocation at, const Given& given);
  /// The effects of a function of a system header, as if all of them happened at the call. `is_given`: something that a
  /// container may have to hold.
  void reach(const clang::FunctionDecl& callee, clang::SourceLocation at, bool is_given, bool destroys = false);
  /// `new` and `delete`, also those of a class.
  void manage_memory(const clang::FunctionDecl& function, clang::SourceLocation at);
  /// The functions that run when such an object is destroyed. `by_pointer`: or one of a class below.
  void destroy(clang::QualType type, clang::SourceLocation at, bool by_pointer = false);
  void block(const std::string& name, std::string_view why, clang::SourceLocation at);
  /// `if_stored`: it matters only if a context was stored before.
  void hide(std::string what, clang::SourceLocation begin, clang::SourceLocation end, bool carries,
            bool if_stored = false);

  /// Adds all of this to the fact about the function.
  void add_to(Json& fact) &&;

  bool stores = false;        ///< a context, in what outlives the function, or in what does not show it
  clang::SourceLocation here; ///< while something is read that is written elsewhere: where it runs

private:
  /// What a function of a system header may do without being followed.
  void hide_library(const clang::FunctionDecl& callee, const std::vector<clang::QualType>& given,
                    clang::SourceLocation at, bool carries);

  Book& book_;
  Values values_;
  Json does_ = Json::list({}), calls_ = Json::list({}), blocks_ = Json::list({}), hidden_ = Json::list({});
};

/// The types of arguments, as callbacks.hpp wants them.
std::vector<clang::QualType> types_given(llvm::ArrayRef<const clang::Expr*> arguments);
/// The place of the name by which a function is called.
clang::SourceLocation name_place(const clang::CallExpr& expr);

} // namespace director::scanning
