#pragma once
// SPDX-License-Identifier: MIT
// Where the facts of a unit come together: classes that implement modules, and functions, each looked at once, as they
// are met.

#include "compiler/clang/places.hpp"
#include "compiler/clang/reach.hpp"

#include <clang/AST/ASTContext.h>

#include <set>
#include <string>
#include <vector>

namespace clang {
class Sema;
} // namespace clang

namespace director::scanning {

class Book {
public:
  /// `is_deep`: bodies of functions in system headers are there, to tell what blocks.
  Book(clang::ASTContext& context, const std::string& directory, bool is_deep)
      : context_(context),
        places_(context, directory),
        is_deep_(is_deep) {}

  /// The key of the function, which is put down for a look if there is a body to see.
  std::string want(const clang::FunctionDecl& function);
  /// One that was put down; null: all have been looked at.
  const clang::FunctionDecl* next();

  clang::ASTContext& context() { return context_; }
  Places& places() { return places_; }
  Reach& reach() { return reach_; }
  bool is_deep() const { return is_deep_; }
  std::vector<Json> functions, classes;
  bool has_templates = false; ///< one has bodies, or a module among its bases

private:
  clang::ASTContext& context_;
  Places places_;
  Reach reach_;
  bool is_deep_;
  std::set<const clang::Decl*> wanted_;
  std::vector<const clang::FunctionDecl*> waiting_;
};

/// One name for one function in all files. What is hidden in a file is told apart by the file.
std::string key_of(const clang::NamedDecl& decl);

/// instantiate.cpp: the bodies that a class inherits from a template, also where no file makes an object of it.
void instantiate_bodies(clang::Sema& sema);
/// classes.cpp: those of the unit that implement modules. Puts down what functions to begin at.
void find_classes(Book& book);
/// bodies.cpp: what a function does that a behaviour is about, and whom it calls, whom it puts down.
void read_function(Book& book, const clang::FunctionDecl& function);

} // namespace director::scanning
