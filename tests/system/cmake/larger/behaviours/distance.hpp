#error "a header beside a behaviour hides one of the same name in an include folder of the program"
