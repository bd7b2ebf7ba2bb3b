// Messages about decoding a list and reading its lines.
