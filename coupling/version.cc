namespace zona::coupling {}
