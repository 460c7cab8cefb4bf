//! The text of DPRNT.
