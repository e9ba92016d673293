// written by the io helper
