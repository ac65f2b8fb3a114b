//! From a document to a checked graph, with all findings on the way.
