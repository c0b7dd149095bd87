#pragma once
// Where the facts of a unit come together: classes that implement modules, and functions, each looked at once, as they
// are met.

#include "compiler/clang/places.hpp"

#include <clang/AST/ASTContext.h>

#include <set>
#include <string>
#include <vector>

namespace director::scanning {

class Book {
public:
  Book(clang::ASTContext& context, const std::string& directory) : context_(context), places_(context, directory) {}

  /// The key of the function, which is put down for a look if there is a body to see.
  std::string want(const clang::FunctionDecl& function);
  /// One that was put down; null: all have been looked at.
  const clang::FunctionDecl* next();

  clang::ASTContext& context() { return context_; }
  Places& places() { return places_; }
  std::vector<Json> functions, classes;

private:
  clang::ASTContext& context_;
  Places places_;
  std::set<const clang::Decl*> wanted_;
  std::vector<const clang::FunctionDecl*> waiting_;
};

/// One name for one function in all files. What is hidden in a file is told apart by the file.
std::string key_of(const clang::NamedDecl& decl);

/// classes.cpp: those of the unit that implement modules. Puts down what functions to begin at.
void find_classes(Book& book);
/// bodies.cpp: what a function does that a behaviour is about, and whom it calls, whom it puts down.
void read_function(Book& book, const clang::FunctionDecl& function);

} // namespace director::scanning
