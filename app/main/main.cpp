#include "app/commands/commands.h"

int main(int argc, char** argv)
{
    return knuckle::runProgram(argc, argv);
}
