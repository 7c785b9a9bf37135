-- What a script that is no study sees of Stiction: require "stiction".
return require "stiction.api"()
