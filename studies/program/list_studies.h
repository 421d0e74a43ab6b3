#pragma once

namespace zona::studies {

/// `zona list`: study kinds and bundled study files.
int list_studies();

}  // namespace zona::studies
