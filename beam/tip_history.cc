#include "beam/tip_history.h"
