//! The paths a file names: of its imports, and of its code where they begin with `crate`, `self` or
//! `super`.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// What a file names; what only its tests name is left out.
#[derive(Debug, Default)]
pub struct Named {
    /// Paths by their segments.
    pub paths: Vec<Vec<String>>,
    /// What imports call something: the name, and the path it stands for.
    pub names: Vec<(String, Vec<String>)>,
}

impl Named {
    pub fn of(text: &str) -> Self {
        let mut named = Self::default();
        let tokens: TokenStream = text.parse().expect("the file is Rust");
        named.read(tokens);
        named
    }

    fn read(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at += 1;
            match token {
                TokenTree::Punct(punct) if punct.as_char() == '#' && of_tests(&tokens[at..]) => {
                    at = item_end(&tokens, at);
                }
                TokenTree::Ident(word) if word == "pub" && is_parenthesis(tokens.get(at)) => {
                    at += 1;
                }
                TokenTree::Ident(word) if word == "use" => {
                    let end = (at..tokens.len()).find(|&end| is_punct(tokens.get(end), ';'));
                    let end = end.unwrap_or(tokens.len());
                    self.import(&mut Vec::new(), &tokens[at..end]);
                    at = end;
                }
                TokenTree::Ident(word) if word == "crate" || word == "self" || word == "super" => {
                    let (path, after) = path(&tokens, at - 1);
                    if path.len() > 1 {
                        self.paths.push(path);
                    }
                    at = after;
                }
                TokenTree::Group(group) => self.read(group.stream()),
                _ => {}
            }
        }
    }

    /// Reads a tree of imports under a prefix.
    fn import(&mut self, prefix: &mut Vec<String>, tokens: &[TokenTree]) {
        let parts = tokens.split(|token| is_punct(Some(token), ','));
        for part in parts.filter(|part| !part.is_empty()) {
            let (segments, after) = path(part, 0);
            let outer = prefix.len();
            prefix.extend(segments.into_iter().filter(|segment| segment != "self" || outer == 0));
            match part.get(after) {
                Some(TokenTree::Group(group)) => {
                    let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                    self.import(prefix, &inner);
                }
                Some(TokenTree::Ident(word)) if word == "as" => {
                    self.take(part[after + 1].to_string(), prefix.clone());
                }
                _ => self.take(prefix.last().cloned().unwrap_or_default(), prefix.clone()),
            }
            prefix.truncate(outer);
        }
    }

    fn take(&mut self, name: String, path: Vec<String>) {
        self.paths.push(path.clone());
        self.names.push((name, path));
    }
}

/// The path that begins at a position, and the position after it (past a `::` before a group).
fn path(tokens: &[TokenTree], mut at: usize) -> (Vec<String>, usize) {
    let mut segments = Vec::new();
    while let Some(TokenTree::Ident(word)) = tokens.get(at) {
        segments.push(word.to_string());
        at += 1;
        if !(is_punct(tokens.get(at), ':') && is_punct(tokens.get(at + 1), ':')) {
            break;
        }
        at += 2;
    }
    (segments, at)
}

/// Whether an attribute, after its `#`, is `[cfg(test)]` or `[cfg(all(test, …))]`.
fn of_tests(tokens: &[TokenTree]) -> bool {
    let Some(TokenTree::Group(group)) = tokens.first() else { return false };
    let text = group.to_string().replace(' ', "");
    text == "[cfg(test)]" || text.starts_with("[cfg(all(test,")
}

/// Where the item ends whose attribute stands at `at`.
fn item_end(tokens: &[TokenTree], at: usize) -> usize {
    let ends = |token: &TokenTree| match token {
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        token => is_punct(Some(token), ';'),
    };
    tokens[at..].iter().position(ends).map_or(tokens.len(), |end| at + end + 1)
}

fn is_parenthesis(token: Option<&TokenTree>) -> bool {
    matches!(token, Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis)
}

fn is_punct(token: Option<&TokenTree>, of: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == of)
}

#[test]
fn paths_of_imports_and_code_are_found_and_those_of_tests_are_not() {
    let named = Named::of(
        "pub(in crate::hidden) use super::{a::{self, B as C}, d::E};\n\
         fn f() -> crate::g::H { // crate::comment\n self::i(\"crate::text\") }\n\
         #[cfg(test)] mod tests { use crate::only::Tests; }\n\
         macro_rules! m { () => { $crate::j::K } }",
    );
    let paths: Vec<String> = named.paths.iter().map(|path| path.join("::")).collect();
    let expected =
        ["super::a", "super::a::B", "super::d::E", "crate::g::H", "self::i", "crate::j::K"];
    assert_eq!(paths, expected);
    assert_eq!(named.names[1].0, "C");
}
