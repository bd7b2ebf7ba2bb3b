// Messages about the words of a list line.
