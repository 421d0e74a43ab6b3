namespace zona::mpm {}
