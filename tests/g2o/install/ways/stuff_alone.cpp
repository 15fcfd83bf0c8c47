// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/command_args.h"
#include "g2o/stuff/property.h"
#include "g2o/stuff/sampler.h"
#include "g2o/stuff/string_tools.h"
#include "g2o/stuff/timeutil.h"

int main(int argc, char** argv) {
  g2o::CommandArgs args;
  int number = 0;
  args.param("n", number, 3, "a number");
  g2o::PropertyMap properties;
  g2o::Property<int>* property = properties.makeProperty<g2o::Property<int>>("n", 1);
  std::cout << g2o::trim(" text ") << g2o::sampleUniform() << g2o::getCurrentTimeAsString() << std::endl;
  return args.parseArgs(argc, argv, false) && number + property->value() == 4 ? 0 : 1;
}
